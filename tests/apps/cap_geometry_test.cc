// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/cap_geometry.h>
#include <apps/fit/isotonic.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace tamp::apps
{
namespace
{
constexpr double rounding = 1e-12; ///< of closed forms, relative

// A cap with d = 2, beta = 55 degrees, R = 0.6, p_a = 40.
const ShearLine line{2, std::tan(55 * std::numbers::pi / 180)};
constexpr double eccentricity = 0.6, centre = 40;

// The point of the cap at an angle, 0 at p_b.
StressPoint on_cap(double angle)
{
  return {centre + eccentricity * line.at(centre) * std::cos(angle),
          line.at(centre) * std::sin(angle)};
}

TEST(CapGeometry, PointAndDirectionOfFlowGiveTheCap)
{
  for (const double angle : {0.4, 0.9, 1.3}) {
    const StressPoint stress = on_cap(angle);
    const double ratio =
        (stress.p - centre) / (eccentricity * eccentricity * stress.q);
    const auto cap = cap_by_flow(line, stress, ratio);
    ASSERT_TRUE(cap);
    EXPECT_NEAR(cap->centre / centre, 1, rounding);
    EXPECT_NEAR(cap->eccentricity / eccentricity, 1, rounding);
    EXPECT_NEAR(cap->yield_pressure / on_cap(0).p, 1, rounding);
  }
}

TEST(CapGeometry, PointAndEccentricityGiveTheCap)
{
  for (const double angle : {0.4, 0.9, 1.3}) {
    const auto cap = cap_through(line, eccentricity, on_cap(angle));
    ASSERT_TRUE(cap);
    EXPECT_NEAR(cap->yield_pressure / on_cap(0).p, 1, rounding);
  }
}

TEST(CapGeometry, StressAboveTheLineHasNoCap)
{
  EXPECT_FALSE(cap_by_flow(line, {10, 1.01 * line.at(10)}, 1.5));
  EXPECT_FALSE(cap_through(line, 0.6, {10, 1.01 * line.at(10)}));
}

TEST(CapGeometry, LineThroughPointsIsFound)
{
  const std::vector<StressPoint> points{
      {1, line.at(1)}, {3, line.at(3)}, {9, line.at(9)}};
  const ShearLine found = fit_shear_line(points);
  EXPECT_NEAR(found.cohesion / line.cohesion, 1, rounding);
  EXPECT_NEAR(found.slope / line.slope, 1, rounding);
  EXPECT_LT(residual_of(found, points), rounding);
}

TEST(CapGeometry, CohesionIsNotNegative)
{
  const std::vector<StressPoint> bent{{1, 0.8}, {2, 2.1}};
  const ShearLine found = fit_shear_line(bent);
  EXPECT_EQ(found.cohesion, 0);
  EXPECT_GT(found.slope, 0.8);
  EXPECT_LT(found.slope, 1.05);
  EXPECT_FALSE(found.through_origin);
  const std::vector<StressPoint> one{{2, 3}, {2.1, 3.1}};
  EXPECT_TRUE(fit_shear_line(one).through_origin);
}

// Points off the line by turns, by a share of q.
std::vector<StressPoint> scattered(double share, double first)
{
  std::vector<StressPoint> points;
  for (int i = 0; i < 8; ++i) {
    const double p = first + i;
    points.push_back({p, line.at(p) * (1 + (i % 2 == 0 ? share : -share))});
  }
  return points;
}

TEST(CapGeometry, ErrorOfCohesionGrowsWithScatterAndDistance)
{
  EXPECT_NEAR(cohesion_error(scattered(0, 1)), 0, 1e-6);
  const double near = cohesion_error(scattered(1e-3, 1));
  EXPECT_GT(near, 0);
  // Twice the scatter is twice the error, but for squares of the scatter.
  EXPECT_NEAR(cohesion_error(scattered(2e-3, 1)) / near, 2, 1e-2);
  EXPECT_GT(cohesion_error(scattered(1e-3, 10)), 4 * near);
  // Nothing is known of the error with two points.
  const auto points = scattered(1e-3, 1);
  EXPECT_EQ(cohesion_error({points.data(), 2}), 0);
}

TEST(Isotonic, RisingValuesStay)
{
  const std::vector<double> values{1, 2, 2.5, 7};
  EXPECT_EQ(isotonic(values), values);
}

TEST(Isotonic, ValuesThatFallShareTheirMean)
{
  const std::vector<double> values{1, 4, 2, 3, 8}, expected{1, 3, 3, 3, 8};
  EXPECT_EQ(isotonic(values), expected);
  const auto blocks = isotonic_blocks(values);
  ASSERT_EQ(blocks.size(), 3u);
  EXPECT_EQ(blocks[1].first, 1u);
  EXPECT_EQ(blocks[1].count, 3u);
}
} // namespace
} // namespace tamp::apps
