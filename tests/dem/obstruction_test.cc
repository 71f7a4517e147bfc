// SPDX-License-Identifier: BSD-3-Clause
#include <dem/obstruction.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace tamp::dem
{
namespace
{
/// Branches of all pairs of a few places.
std::vector<Branch> all_pairs(const std::vector<Vector3> &place)
{
  std::vector<Branch> branches;
  for (std::uint32_t i = 0; i < place.size(); ++i)
    for (std::uint32_t j = i + 1; j < place.size(); ++j)
      branches.push_back({{i, j}, place[j] - place[i]});
  return branches;
}

/// Three grains; the third sees the others at an angle [degrees].
std::vector<Vector3> triangle(double angle)
{
  const double half = angle / 360 * std::numbers::pi;
  return {{-std::sin(half), -std::cos(half), 0},
          {std::sin(half), -std::cos(half), 0},
          {0, 0, 0}};
}

TEST(Obstruction, LeavesDenseNeighboursAlone)
{
  constexpr double tolerance = 3e-4; // its value at 60 degrees is 2.4e-4
  for (double share : obstruction(all_pairs(triangle(60)), 3))
    EXPECT_NEAR(share, 0, tolerance);
}

TEST(Obstruction, ClosesTheContactBehindAGrain)
{
  constexpr double tolerance = 1e-12; // the formula itself
  for (double angle : {70., 90., 100., 150.}) {
    const auto share = obstruction(all_pairs(triangle(angle)), 3);
    EXPECT_NEAR(
        share[0], 1 / (1 + std::exp(-50 * (angle / 180 - 0.5))), tolerance);
    EXPECT_EQ(share[1], 0);
    EXPECT_EQ(share[2], 0);
  }
  EXPECT_GT(obstruction(all_pairs(triangle(120)), 3)[0], 0.99);
}

TEST(Obstruction, AddsUpOverTrianglesToOneAtMost)
{
  // A square: each diagonal is the longest side of two triangles at 90 degrees.
  constexpr double tolerance = 1e-12; // rounding
  const std::vector<Vector3> square = {
      {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto branches = all_pairs(square);
  const auto share = obstruction(branches, 4);
  for (std::size_t c = 0; c < branches.size(); ++c) {
    const bool diagonal = branches[c].way.norm() > 1.2;
    EXPECT_NEAR(share[c], diagonal ? 1 : 0, tolerance);
    EXPECT_LE(share[c], 1);
  }
}

TEST(Obstruction, DoesNotDependOnTheOrder)
{
  auto branches = all_pairs({{0, 0, 0}, {1, 0.1, 0}, {2, 0, 0.3}, {1, 1, 0}});
  const auto share = obstruction(branches, 4);
  std::reverse(branches.begin(), branches.end());
  auto other = obstruction(branches, 4);
  std::reverse(other.begin(), other.end());
  EXPECT_GT(*std::max_element(share.begin(), share.end()), 0.5);
  for (std::size_t c = 0; c < share.size(); ++c)
    EXPECT_DOUBLE_EQ(share[c], other[c]);
}

TEST(Obstruction, TakesImagesForNoTriangle)
{
  // 2 touches 0 through the boundary: the three are a chain.
  auto branches = all_pairs(triangle(150));
  branches[0].way = Vector3(-0.9, 0, 0);
  for (double share : obstruction(branches, 3))
    EXPECT_EQ(share, 0);
}
} // namespace
} // namespace tamp::dem
