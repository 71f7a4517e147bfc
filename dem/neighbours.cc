// SPDX-License-Identifier: BSD-3-Clause
#include <dem/kernel/kernel.h>
#include <dem/neighbours.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace tamp::dem
{
namespace
{
PairSearch search_in(const PeriodicBox &box, double gap)
{
  PairSearch search{{}, gap};
  for (int k = 0; k < 9; ++k)
    search.box[k] = box.h(k / 3, k % 3);
  return search;
}

/// The bin k of n in a period and those beside it, in rising order.
struct Beside {
  int bin[3];
  int count;

  Beside(int k, int n) : bin{0, 1, 2}, count(std::min(n, 3))
  {
    if (n <= 3)
      return;
    for (int c = 0; c < 3; ++c)
      bin[c] = (k - 1 + c + n) % n;
    std::ranges::sort(bin);
  }
  const int *begin() const { return bin; }
  const int *end() const { return bin + count; }
};

/// Grains in the bins of a grid over the fractional unit cube, each bin at
/// least one reach wide.
class Grid
{
public:
  Grid(const PeriodicBox &box,
       std::span<const Vector3> place,
       std::span<const double> radius,
       double reach);

  /// The near pairs among grains in the same bin or in bins beside each other,
  /// in any order.
  std::vector<Pair> match(const PairSearch &search,
                          const PairLoops &loops) const;

private:
  /// A bin and those beside it that come after it, as stretches of positions.
  struct Stretches {
    std::array<Positions, 27> part;
    std::size_t count = 0, grains = 0;
  };

  std::size_t join(int x, int y, int z) const
  {
    return (std::size_t(z) * count_[1] + y) * count_[0] + x;
  }
  std::size_t bin(const Vector3 &s) const;
  Stretches from(int x, int y, int z) const;

  std::array<int, 3> count_;
  std::vector<std::size_t> start_; // position of the first grain of a bin
  std::vector<double> x_, y_, z_, radius_;
  std::vector<std::uint32_t> grain_;
};

std::size_t Grid::bin(const Vector3 &s) const
{
  std::array<int, 3> k;
  for (int a = 0; a < 3; ++a)
    k[a] = std::min(int((s[a] - std::floor(s[a])) * count_[a]), count_[a] - 1);
  return join(k[0], k[1], k[2]);
}

Grid::Grid(const PeriodicBox &box,
           std::span<const Vector3> place,
           std::span<const double> radius,
           double reach)
{
  const Matrix3 inverse = box.h.inverse();
  for (int a = 0; a < 3; ++a)
    count_[a] = std::max(1, int(1 / (inverse.row(a).norm() * reach)));
  start_.assign(std::size_t(count_[0]) * count_[1] * count_[2] + 1, 0);
  std::vector<std::size_t> bin_of;
  bin_of.reserve(place.size());
  for (const Vector3 &s : place) {
    bin_of.push_back(bin(s));
    ++start_[bin_of.back() + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (auto *column : {&x_, &y_, &z_, &radius_})
    column->resize(place.size() + OrderedGrains::room);
  grain_.resize(place.size() + OrderedGrains::room);
  for (std::size_t i = 0; i < place.size(); ++i) {
    const std::size_t at = next[bin_of[i]]++;
    x_[at] = place[i][0];
    y_[at] = place[i][1];
    z_[at] = place[i][2];
    radius_[at] = radius[i];
    grain_[at] = std::uint32_t(i);
  }
}

Grid::Stretches Grid::from(int x, int y, int z) const
{
  const std::size_t own = join(x, y, z);
  Stretches result;
  result.part[result.count++] = {start_[own], start_[own + 1]};
  for (int c : Beside(z, count_[2]))
    for (int b : Beside(y, count_[1]))
      for (int a : Beside(x, count_[0])) {
        const std::size_t other = join(a, b, c);
        if (other <= own)
          continue;
        Positions &last = result.part[result.count - 1];
        if (last.last == start_[other])
          last.last = start_[other + 1];
        else
          result.part[result.count++] = {start_[other], start_[other + 1]};
      }
  for (std::size_t k = 0; k < result.count; ++k)
    result.grains += result.part[k].last - result.part[k].first;
  return result;
}

std::vector<Pair> Grid::match(const PairSearch &search,
                              const PairLoops &loops) const
{
  const OrderedGrains grains = {
      x_.data(), y_.data(), z_.data(), radius_.data(), grain_.data()};
  std::vector<Pair> pairs;
  std::size_t found = 0;
  for (int z = 0; z < count_[2]; ++z)
    for (int y = 0; y < count_[1]; ++y)
      for (int x = 0; x < count_[0]; ++x) {
        const std::size_t own = join(x, y, z);
        const Positions those = {start_[own], start_[own + 1]};
        const Stretches others = from(x, y, z);
        const std::size_t most =
            found + (those.last - those.first) * others.grains;
        if (pairs.size() < most)
          pairs.resize(2 * most);
        found += loops.match(search,
                             grains,
                             those,
                             others.part.data(),
                             others.count,
                             pairs.data() + found);
      }
  pairs.resize(found);
  return pairs;
}

/// Puts pairs of `grains` grains in order by one of their two numbers; equal
/// ones stay as they are.
void sort_by(std::uint32_t Pair::*number,
             std::size_t grains,
             std::vector<Pair> &pairs)
{
  std::vector<std::size_t> next(grains + 1, 0);
  for (const Pair &pair : pairs)
    ++next[pair.*number + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Pair> sorted(pairs.size());
  for (const Pair &pair : pairs)
    sorted[next[pair.*number]++] = pair;
  pairs = std::move(sorted);
}
} // namespace

Neighbours find_neighbours(const PeriodicBox &box,
                           std::span<const Vector3> place,
                           std::span<const double> radius,
                           double skin,
                           InstructionSet set)
{
  const double reach = 2 * std::ranges::max(radius) + skin;
  // The nearest image is found by rounding, exact up to half a width.
  if (box.smallest_width() < 2 * reach)
    throw std::runtime_error("unit cell too small: its width " +
                             std::to_string(box.smallest_width()) +
                             " m is less than " + std::to_string(2 * reach) +
                             " m, two contact distances; use more grains");
  Neighbours result{{}, skin, box.h, {place.begin(), place.end()}};
  result.pairs = Grid(box, place, radius, reach)
                     .match(search_in(box, skin), kernel_of(set).pairs);
  sort_by(&Pair::second, place.size(), result.pairs);
  sort_by(&Pair::first, place.size(), result.pairs);
  return result;
}

bool still_hold(const Neighbours &neighbours,
                const PeriodicBox &box,
                std::span<const Vector3> place,
                double largest_radius,
                double gap)
{
  if (neighbours.place.size() != place.size())
    return false;
  // |h (s + ds)| >= (smallest stretch of h h_0^-1) |h_0 s| - 2 max |h ds|
  const Matrix3 stretch = box.h * neighbours.box.inverse();
  const Eigen::SelfAdjointEigenSolver<Matrix3> squares(
      stretch.transpose() * stretch, Eigen::EigenvaluesOnly);
  const double shrink =
      std::min(1.0, std::sqrt(squares.eigenvalues().minCoeff()));
  double drift2 = 0;
  for (std::size_t i = 0; i < place.size(); ++i)
    drift2 = std::max(drift2,
                      (box.h * (place[i] - neighbours.place[i])).squaredNorm());
  const double reach = 2 * largest_radius;
  return shrink * (reach + neighbours.skin) - 2 * std::sqrt(drift2) >=
         reach + gap;
}

void find_near_pairs(const Neighbours &neighbours,
                     const PeriodicBox &box,
                     std::span<const Vector3> place,
                     std::span<const double> radius,
                     double gap,
                     std::vector<NearPair> &near,
                     InstructionSet set)
{
  static_assert(sizeof(Vector3) == 3 * sizeof(double));
  near.resize(neighbours.pairs.size());
  near.resize(
      kernel_of(set).pairs.filter(search_in(box, gap),
                                  neighbours.pairs.data(),
                                  neighbours.pairs.size(),
                                  place.empty() ? nullptr : place[0].data(),
                                  radius.data(),
                                  near.data()));
}
} // namespace tamp::dem
