// SPDX-License-Identifier: BSD-3-Clause
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
/// A grid of bins over the fractional unit cube, each at least one reach wide.
class Grid
{
public:
  Grid(const PeriodicBox &box, std::span<const Vector3> place, double reach)
      : bin_of_(place.size())
  {
    const Matrix3 inverse = box.h.inverse();
    for (int a = 0; a < 3; ++a)
      count_[a] = std::max(1, int(1 / (inverse.row(a).norm() * reach)));
    start_.assign(std::size_t(count_[0]) * count_[1] * count_[2] + 1, 0);
    for (std::size_t i = 0; i < place.size(); ++i)
      ++start_[(bin_of_[i] = bin(place[i])) + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    members_.resize(place.size());
    for (std::size_t i = 0; i < place.size(); ++i)
      members_[next[bin_of_[i]]++] = std::uint32_t(i);
  }

  /// Calls `visit` with every grain in the bins around that of grain i.
  template <class Visitor>
  void around(std::size_t i, Visitor &&visit) const
  {
    const auto [x, y, z] = split(bin_of_[i]);
    for (int dz : steps(2))
      for (int dy : steps(1))
        for (int dx : steps(0)) {
          const std::size_t b = join(x + dx, y + dy, z + dz);
          for (std::uint32_t k = start_[b]; k < start_[b + 1]; ++k)
            visit(members_[k]);
        }
  }

private:
  std::span<const int> steps(int axis) const
  {
    static constexpr std::array<int, 3> all = {-1, 0, 1};
    if (count_[axis] == 1)
      return std::span(all).subspan(1, 1);
    return std::span(all).subspan(count_[axis] == 2 ? 1 : 0);
  }
  std::size_t bin(const Vector3 &s) const
  {
    std::array<int, 3> k;
    for (int a = 0; a < 3; ++a)
      k[a] =
          std::min(int((s[a] - std::floor(s[a])) * count_[a]), count_[a] - 1);
    return join(k[0], k[1], k[2]);
  }
  std::size_t join(int x, int y, int z) const
  {
    const auto wrap = [](int k, int n) { return (k + n) % n; };
    return (std::size_t(wrap(z, count_[2])) * count_[1] + wrap(y, count_[1])) *
               count_[0] +
           wrap(x, count_[0]);
  }
  std::array<int, 3> split(std::size_t b) const
  {
    const int x = int(b % count_[0]), rest = int(b / count_[0]);
    return {x, rest % count_[1], rest / count_[1]};
  }

  std::array<int, 3> count_;
  std::vector<std::size_t> bin_of_;
  std::vector<std::uint32_t> start_, members_;
};
} // namespace

Neighbours find_neighbours(const PeriodicBox &box,
                           std::span<const Vector3> place,
                           std::span<const double> radius,
                           double skin)
{
  const double reach = 2 * std::ranges::max(radius) + skin;
  // The nearest image is found by rounding, exact up to half a width.
  if (box.smallest_width() < 2 * reach)
    throw std::runtime_error("unit cell too small: its width " +
                             std::to_string(box.smallest_width()) +
                             " m is less than " + std::to_string(2 * reach) +
                             " m, two contact distances; use more grains");
  const Grid grid(box, place, reach);
  Neighbours result{{}, skin, box.h, {place.begin(), place.end()}};
  std::vector<std::uint32_t> partners;
  for (std::uint32_t i = 0; i < place.size(); ++i) {
    partners.clear();
    grid.around(i, [&](std::uint32_t j) {
      if (j <= i)
        return;
      const double limit = radius[i] + radius[j] + skin;
      if (box.nearest_image(place[j] - place[i]).squaredNorm() < limit * limit)
        partners.push_back(j);
    });
    std::ranges::sort(partners);
    for (std::uint32_t j : partners)
      result.pairs.push_back({i, j});
  }
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
                     std::vector<NearPair> &near)
{
  near.clear();
  near.reserve(neighbours.pairs.size());
  for (const Pair &pair : neighbours.pairs) {
    const double sum = radius[pair.first] + radius[pair.second];
    const Vector3 branch =
        box.nearest_image(place[pair.second] - place[pair.first]);
    const double square = branch.squaredNorm();
    if (square < (sum + gap) * (sum + gap))
      near.push_back({pair, branch, sum - std::sqrt(square)});
  }
}
} // namespace tamp::dem
