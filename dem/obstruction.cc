// SPDX-License-Identifier: BSD-3-Clause
#include <dem/obstruction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace tamp::dem
{
namespace
{
/// A grain that touches, and the contact.
struct Link {
  std::uint32_t other;
  std::size_t contact;
  bool operator<(const Link &link) const { return other < link.other; }
};

using Links = std::vector<std::vector<Link>>;

/// Of each grain, those with a larger index that touch it, sorted.
Links links_of(std::span<const Branch> branches, std::size_t grains)
{
  Links links(grains);
  for (std::size_t c = 0; c < branches.size(); ++c)
    links[branches[c].pair.first].push_back({branches[c].pair.second, c});
  for (std::vector<Link> &own : links)
    std::sort(own.begin(), own.end());
  return links;
}

/// Adds what one triangle takes from the contact of its longest side.
void close_triangle(const std::array<std::size_t, 3> &side,
                    std::span<const Branch> branches,
                    std::vector<double> &result)
{
  std::array<double, 3> square;
  for (int k = 0; k < 3; ++k)
    square[k] = branches[side[k]].way.squaredNorm();
  const auto longest = std::max_element(square.begin(), square.end());
  const int across = static_cast<int>(longest - square.begin());
  const double one = square[(across + 1) % 3], two = square[(across + 2) % 3];
  const double cosine = (one + two - *longest) / (2 * std::sqrt(one * two));
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
  result[side[across]] +=
      1 / (1 + std::exp(-50 * (angle / std::numbers::pi - 0.5)));
}
} // namespace

std::vector<double> obstruction(std::span<const Branch> branches,
                                std::size_t grains)
{
  const Links links = links_of(branches, grains);
  std::vector<double> result(branches.size(), 0.0);
  for (std::size_t ij = 0; ij < branches.size(); ++ij) {
    const auto [i, j] = branches[ij].pair;
    for (const Link &jk : links[j]) {
      const auto ik =
          std::lower_bound(links[i].begin(), links[i].end(), Link{jk.other, 0});
      if (ik == links[i].end() || ik->other != jk.other || jk.other <= j ||
          j <= i)
        continue;
      // Images of one grain may close the pairs, but no triangle.
      const Vector3 gap = branches[ij].way + branches[jk.contact].way -
                          branches[ik->contact].way;
      if (gap.norm() > 1e-6 * branches[ij].way.norm())
        continue;
      close_triangle({ij, jk.contact, ik->contact}, branches, result);
    }
  }
  for (double &share : result)
    share = std::min(share, 1.0);
  return result;
}
} // namespace tamp::dem
