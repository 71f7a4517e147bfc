// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/curve_targets.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
constexpr double smallest_scale = 0.01; // of the peak
constexpr double smallest_share = 0.05; // of the peak, in unloading
constexpr std::size_t fewest = 5;
// At the end of a path: of a density; of the peak, twice what equilibrium of a
// die leaves open.
constexpr double rounding = 1e-6, balance = 2e-3;

double recovered(const CompactionCurve &curve, const CompactionPoint &point)
{
  return std::log(curve.peak().relative_density / point.relative_density);
}

// Where a rising or falling quantity passes a value: linear between points.
struct Crossing {
  std::size_t before = 0;
  double part = 0;

  template <class Value>
  double of(const std::vector<CompactionPoint> &points, Value value) const
  {
    const double first = value(points[before]);
    return first + part * (value(points[before + 1]) - first);
  }
};

template <class Value>
std::optional<Crossing> crossing(const std::vector<CompactionPoint> &points,
                                 Value value,
                                 double goal,
                                 double slack)
{
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double a = value(points[i]), b = value(points[i + 1]);
    if ((goal - a) * (goal - b) <= 0 && a != b)
      return Crossing{i, (goal - a) / (b - a)};
  }
  if (points.size() > 1 && std::abs(goal - value(points.back())) <= slack)
    return Crossing{points.size() - 2, 1};
  return {};
}

double density_of(const CompactionPoint &point)
{
  return point.relative_density;
}
} // namespace

CurveTargets::CurveTargets(const CompactionCurve &measured,
                           double start_density)
{
  take_loading(measured, start_density);
  if (targets_.size() < fewest)
    throw std::invalid_argument(
        fmt::format("of {} measured places of loading {} lie above the "
                    "relative density {:.4g} at which simulations start; "
                    "expected at least {}",
                    measured.loading.size(),
                    targets_.size(),
                    start_density,
                    fewest));
  if (measured.has_lateral) {
    const double least = smallest_scale * measured.peak().axial;
    for (const CompactionPoint &point : measured.loading)
      if (point.relative_density > start_density)
        targets_.push_back({TargetKind::loading_lateral,
                            point.relative_density,
                            point.lateral,
                            std::max(std::abs(point.lateral), least)});
  }
  take_unloading(measured);
}

void CurveTargets::take_loading(const CompactionCurve &measured,
                                double start_density)
{
  largest_density_ = measured.peak().relative_density;
  const double least = smallest_scale * measured.peak().axial;
  for (const CompactionPoint &point : measured.loading)
    if (point.relative_density > start_density)
      targets_.push_back({TargetKind::loading_axial,
                          point.relative_density,
                          point.axial,
                          std::max(point.axial, least)});
    else
      ++left_out_;
}

void CurveTargets::take_unloading(const CompactionCurve &measured)
{
  const double peak = measured.peak().axial;
  std::vector<const CompactionPoint *> used;
  double last = 0;
  for (const CompactionPoint &point : measured.unloading) {
    if (point.axial < smallest_share * peak || point.axial > peak)
      ++left_out_;
    else {
      used.push_back(&point);
      last = std::max(last, recovered(measured, point));
    }
  }
  if (used.empty() || !(last > 0))
    return;
  for (const CompactionPoint *point : used) {
    lowest_share_ = lowest_share_ > 0
                        ? std::min(lowest_share_, point->axial / peak)
                        : point->axial / peak;
    targets_.push_back({TargetKind::unloading_strain,
                        point->axial / peak,
                        recovered(measured, *point),
                        last});
  }
  if (measured.has_lateral)
    for (const CompactionPoint *point : used)
      targets_.push_back(
          {TargetKind::unloading_lateral,
           point->axial / peak,
           point->lateral / peak,
           std::max(std::abs(point->lateral) / peak, smallest_scale)});
}

std::optional<std::vector<double>>
CurveTargets::simulated(const CompactionCurve &curve) const
{
  if (curve.loading.size() < 2)
    return {};
  const double peak = curve.peak().axial;
  std::vector<CompactionPoint> back{curve.peak()};
  back.insert(back.end(), curve.unloading.begin(), curve.unloading.end());
  const auto share = [&](const CompactionPoint &point) {
    return point.axial / peak;
  };
  std::vector<double> values;
  for (const CurveTarget &target : targets_) {
    const bool loading = target.kind == TargetKind::loading_axial ||
                         target.kind == TargetKind::loading_lateral;
    const auto &points = loading ? curve.loading : back;
    const auto found =
        loading ? crossing(points, density_of, target.place, rounding)
                : crossing(points, share, target.place, balance);
    if (!found)
      return {};
    values.push_back(found->of(points, [&](const CompactionPoint &point) {
      switch (target.kind) {
      case TargetKind::loading_axial:
        return point.axial;
      case TargetKind::loading_lateral:
        return point.lateral;
      case TargetKind::unloading_strain:
        return recovered(curve, point);
      default:
        return point.lateral / peak;
      }
    }));
  }
  return values;
}

std::optional<std::vector<double>>
CurveTargets::residuals(const CompactionCurve &curve) const
{
  auto values = simulated(curve);
  if (values)
    for (std::size_t i = 0; i < targets_.size(); ++i)
      (*values)[i] = ((*values)[i] - targets_[i].value) / targets_[i].scale;
  return values;
}

std::string CurveTargets::reach(const CompactionCurve &curve) const
{
  if (curve.loading.empty())
    return "it does not begin";
  const CompactionPoint &peak = curve.peak();
  const CompactionPoint &end =
      curve.unloading.empty() ? peak : curve.unloading.back();
  std::string words = fmt::format("it comes to a relative density of {:.5g}",
                                  peak.relative_density);
  std::string wanted = fmt::format("{:.5g}", largest_density_);
  if (lowest_share_ > 0) {
    words += fmt::format(" and back to {:.4g} % of its peak pressure",
                         100 * end.axial / peak.axial);
    wanted += fmt::format(" and {:.4g} %", 100 * lowest_share_);
  }
  return words + ", the measured curve to " + wanted;
}

double misfit_of(std::span<const double> residuals)
{
  double sum = 0;
  for (const double residual : residuals)
    sum += residual * residual;
  return std::sqrt(sum / static_cast<double>(residuals.size()));
}
} // namespace tamp::apps
