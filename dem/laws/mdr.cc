// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/mdr.h>

#include <algorithm>

namespace tamp::dem
{
namespace
{
/// A memory that may be written without harm to the contact.
struct Scratch {
  std::array<double, Mdr::more> more = {};
  NormalMemory<double> memory = {0, 0, nullptr};

  Scratch() { memory.more = more.data(); }
  explicit Scratch(const NormalMemory<double> &other) : memory(other)
  {
    std::copy_n(other.more, Mdr::more, more.begin());
    memory.more = more.data();
  }
  Scratch(const Scratch &) = delete;
  Scratch &operator=(const Scratch &) = delete;
};

std::array<double, 2> radii(const PairShape<double> &pair)
{
  return {0.5 * (pair.radius_sum - pair.radius_difference),
          0.5 * (pair.radius_sum + pair.radius_difference)};
}

/// Overlap at which two intersecting spheres cut `depth` off one of them; the
/// other has radius `other`.
double overlap_of_cut(double depth, double other, double radius_sum)
{
  const double half = other + depth;
  return half - std::sqrt(std::max(0.0, half * half - 2 * radius_sum * depth));
}

/// Gauss-Legendre rule with 8 points on [-1, 1], its positive half.
struct Node {
  double place, weight;
};
constexpr std::array<Node, 4> gauss = {{
    {0.1834346424956498, 0.3626837833783620},
    {0.5255324099163290, 0.3137066458778873},
    {0.7966664774136267, 0.2223810344533745},
    {0.9602898564975363, 0.1012285362903763},
}};
} // namespace

double Mdr::loading_slope(double overlap,
                          const PairShape<double> &pair,
                          const NormalMemory<double> &memory) const
{
  if (!(overlap > 0))
    return 0;
  const double step = 1e-6 * overlap;
  Scratch here(memory), further(memory);
  const double force = (*this)(overlap, pair, here.memory).force;
  return ((*this)(overlap + step, pair, further.memory).force - force) / step;
}

double Mdr::steepest_slope(const PairShape<double> &pair,
                           const NormalMemory<double> &memory) const
{
  const std::array<double, 2> radius = radii(pair);
  const auto side = sides(memory.largest_overlap, pair, memory);
  double push = 0, recovery = 0, bulk = 0;
  for (int k = 0; k < 2; ++k) {
    // A hair past yield, where unloading is steeper than loading.
    const double yielded = (1 + 1e-9) * flat_.yield_ratio() * radius[k];
    const FlatPeak<double> peak =
        flat_.peak(std::max(side[k].peak.overlap, yielded), radius[k]);
    push += peak.force;
    recovery += peak.recovery;
    const auto old =
        MdrMemory<double>::read(memory.more + k * MdrMemory<double>::size);
    bulk +=
        old.bulk_stiffness * (side[k].area + 2 * std::numbers::pi * radius[k] *
                                                 side[k].bulk_overlap);
  }
  return 2 / std::numbers::pi * push / recovery + 0.5 * bulk;
}

bool Mdr::is_plastic(const PairShape<double> &pair,
                     const NormalMemory<double> &memory) const
{
  const std::array<double, 2> radius = radii(pair);
  return memory.more[0] > flat_.yield_ratio() * radius[0] ||
         memory.more[MdrMemory<double>::size] > flat_.yield_ratio() * radius[1];
}

double Mdr::virgin_work(double overlap, const PairShape<double> &pair) const
{
  const auto [first, second] = radii(pair);
  const double yield = flat_.yield_ratio();
  const double small = std::min(first, second);
  // In terms of the square root of the overlap Hertz's force is smooth.
  std::array<double, 5> ends = {
      0,
      std::sqrt(overlap_of_cut(yield * first, second, pair.radius_sum)),
      std::sqrt(overlap_of_cut(yield * second, first, pair.radius_sum)),
      std::sqrt(overlap_of_cut(SphereOnFlat::overlap_limit * small,
                               pair.radius_sum - small,
                               pair.radius_sum)),
      std::sqrt(overlap)};
  for (double &end : ends)
    end = std::min(end, ends.back());
  std::sort(ends.begin(), ends.end());
  const auto integrand = [&](double root) {
    Scratch virgin;
    return 2 * root * (*this)(root * root, pair, virgin.memory).force;
  };
  constexpr int panels = 2;
  double work = 0;
  for (std::size_t part = 0; part + 1 < ends.size(); ++part)
    for (int panel = 0; panel < panels; ++panel) {
      const double half = (ends[part + 1] - ends[part]) / (2 * panels);
      if (half <= 0)
        continue;
      const double middle = ends[part] + (2 * panel + 1) * half;
      for (const Node &node : gauss)
        work += half * node.weight *
                (integrand(middle - half * node.place) +
                 integrand(middle + half * node.place));
    }
  return work;
}

NormalEnergy Mdr::energy(double overlap,
                         const PairShape<double> &pair,
                         const NormalMemory<double> &memory) const
{
  const std::array<double, 2> radius = radii(pair);
  const auto side = sides(overlap, pair, memory);
  Scratch after(memory);
  (*this)(overlap, pair, after.memory);
  double bulk = 0, local_sum = 0;
  for (int k = 0; k < 2; ++k) {
    const MdrSide<double> &s = side[k];
    const auto old =
        MdrMemory<double>::read(memory.more + k * MdrMemory<double>::size);
    const double push = old.bulk_stiffness * s.bulk_overlap * s.area;
    // The local force is there while the grain yields in bulk.
    bulk += 0.5 * (s.force - 0.5 * push) * s.bulk_overlap;
    local_sum += s.local_overlap;
  }
  const double open = 1 - memory.more[2 * MdrMemory<double>::size];
  if (!is_plastic(pair, after.memory))
    return {open * (virgin_work(std::max(local_sum, 0.0), pair) + bulk), 0};

  // The sides share the overlap in unloading as their recoveries do.
  const double recovery = side[0].peak.recovery + side[1].peak.recovery;
  NormalEnergy energy;
  double stored = 0, peak_sum = 0;
  for (int k = 0; k < 2; ++k) {
    const MdrSide<double> &s = side[k];
    const double share = 2 * s.peak.recovery / recovery;
    energy.elastic +=
        flat_.stored_work(s.local_overlap, s.peak, radius[k]) / share;
    stored += flat_.stored_work(s.peak.overlap, s.peak, radius[k]) / share;
    peak_sum += s.peak.overlap;
  }
  energy.elastic = open * (energy.elastic + bulk);
  energy.dissipated = open * (virgin_work(peak_sum, pair) - stored);
  return energy;
}
} // namespace tamp::dem
