// SPDX-License-Identifier: BSD-3-Clause
#include <fem/stress_search.h>
#include <fem/yield_search.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tamp::fem
{
namespace
{
using SymmetricTensor = dealii::SymmetricTensor<2, 3>;

// See YieldSearch::ended().
constexpr double fall = 0.98, growth = 1.01, plateau = 0.01;
constexpr double largest_compaction = 0.01, largest_dilation = 0.05;

SymmetricTensor logarithmic_strain(const dealii::Tensor<2, 3> &F)
{
  const path::Six six = path::left_split(F).strain;
  SymmetricTensor strain;
  for (unsigned i = 0; i < 3; ++i)
    strain[i][i] = six[i];
  strain[1][2] = six[3];
  strain[0][2] = six[4];
  strain[0][1] = six[5];
  return strain;
}

double equivalent(const SymmetricTensor &distortion)
{
  return std::sqrt(2. / 3) * distortion.norm();
}
} // namespace

double YieldSearch::Entry::irreversible() const
{
  return std::hypot(compaction, equivalent(distortion));
}

void YieldSearch::take(const PathRecord &record)
{
  const SymmetricTensor stress = record.response.stress;
  const SymmetricTensor strain = logarithmic_strain(record.F);
  Entry entry;
  if (entries_.empty())
    start_strain_ = strain;
  else {
    entry = entries_.back();
    const SymmetricTensor more = strain - strain_, force = stress - stress_;
    const SymmetricTensor middle = 0.5 * (stress + stress_);
    const MeasuredModuli moduli = moduli_.at(-trace(middle) / 3);
    const double compaction = -trace(more) + trace(force) / (3 * moduli.bulk);
    const SymmetricTensor distortion =
        deviator(more) - deviator(force) / (2 * moduli.shear);
    entry.compaction += compaction;
    entry.distortion += distortion;
    entry.work +=
        -trace(middle) / 3 * compaction + deviator(middle) * distortion;
  }
  entry.pressure = -trace(stress) / 3;
  entry.deviatoric_stress = std::sqrt(1.5) * deviator(stress).norm();
  entry.shear = equivalent(deviator(strain - start_strain_));
  strain_ = strain;
  stress_ = stress;
  entries_.push_back(entry);
}

bool YieldSearch::yielded() const
{
  return !entries_.empty() &&
         entries_.back().irreversible() >= limits_.strain &&
         entries_.back().work >= limits_.work;
}

std::size_t YieldSearch::peak() const
{
  const auto top =
      std::ranges::max_element(entries_, {}, &Entry::deviatoric_stress);
  return static_cast<std::size_t>(std::distance(entries_.begin(), top));
}

bool YieldSearch::peaked() const
{
  return !entries_.empty() &&
         entries_.back().deviatoric_stress <
             fall * entries_[peak()].deviatoric_stress &&
         entries_[peak()].irreversible() > 0.5 * limits_.strain;
}

bool YieldSearch::critical() const
{
  if (!yielded())
    return false;
  const Entry &last = entries_.back();
  return std::ranges::any_of(entries_, [&](const Entry &entry) {
    return entry.irreversible() >= limits_.strain &&
           entry.shear <= last.shear - plateau &&
           last.deviatoric_stress <= growth * entry.deviatoric_stress;
  });
}

bool YieldSearch::ended() const
{
  return peaked() || critical() ||
         (!entries_.empty() &&
          (entries_.back().compaction > largest_compaction ||
           entries_.back().compaction < -largest_dilation));
}

YieldPoint YieldSearch::point(YieldCriterion criterion,
                              const Entry &entry,
                              std::size_t earlier) const
{
  // The last state before it from which half the limit was gone.
  const auto gone = [&](const Entry &from) {
    return std::hypot(entry.compaction - from.compaction,
                      equivalent(entry.distortion - from.distortion));
  };
  std::size_t from = 0;
  for (std::size_t i = 0; i < earlier; ++i)
    if (gone(entries_[i]) >= 0.5 * limits_.strain)
      from = i;
  return {criterion,
          entry.pressure,
          entry.deviatoric_stress,
          entry.compaction - entries_[from].compaction,
          equivalent(entry.distortion - entries_[from].distortion)};
}

std::optional<YieldPoint> YieldSearch::crossing(YieldCriterion criterion) const
{
  const bool strain = criterion == YieldCriterion::strain;
  const double limit = strain ? limits_.strain : limits_.work;
  const auto measure = [strain](const Entry &entry) {
    return strain ? entry.irreversible() : entry.work;
  };
  const auto beyond = std::ranges::find_if(
      entries_, [&](const Entry &entry) { return measure(entry) >= limit; });
  if (beyond == entries_.end() || beyond == entries_.begin())
    return {};
  const Entry &low = *std::prev(beyond), &high = *beyond;
  const double share = (limit - measure(low)) / (measure(high) - measure(low));
  const auto between = [share](const auto &a, const auto &b) {
    return a + share * (b - a);
  };
  Entry entry;
  entry.pressure = between(low.pressure, high.pressure);
  entry.deviatoric_stress =
      between(low.deviatoric_stress, high.deviatoric_stress);
  entry.shear = between(low.shear, high.shear);
  entry.compaction = between(low.compaction, high.compaction);
  entry.distortion = between(low.distortion, high.distortion);
  entry.work = between(low.work, high.work);
  return point(
      criterion, entry, static_cast<std::size_t>(beyond - entries_.begin()));
}

std::vector<YieldPoint> YieldSearch::points(bool with_peak) const
{
  std::vector<YieldPoint> points;
  for (const auto criterion : {YieldCriterion::strain, YieldCriterion::work})
    if (const auto found = crossing(criterion))
      points.push_back(*found);
  if (with_peak && (peaked() || critical()))
    points.push_back(point(YieldCriterion::peak, entries_[peak()], peak()));
  return points;
}
} // namespace tamp::fem
