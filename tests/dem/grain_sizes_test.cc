// SPDX-License-Identifier: BSD-3-Clause
#include <dem/grain_sizes.h>
#include <tests/dem/sample_cells.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tamp::dem
{
namespace
{
using test::message_of;

struct Moments {
  double mean, deviation; // of the diameter
};

Moments moments(const std::vector<double> &radius)
{
  double sum = 0, square = 0;
  for (double r : radius) {
    sum += 2 * r;
    square += 4 * r * r;
  }
  const double n = double(radius.size()), mean = sum / n;
  return {mean, std::sqrt(square / n - mean * mean)};
}

/// A distribution whose cut-offs lie four deviations away.
GrainSizes wide(SizeDistribution distribution)
{
  GrainSizes sizes;
  sizes.distribution = distribution;
  sizes.minimum_diameter = 80e-6;
  sizes.maximum_diameter = 320e-6;
  sizes.mean_diameter = 200e-6;
  sizes.standard_deviation = 30e-6;
  return sizes;
}

TEST(GrainSizes, UniformRadiiAreEquallySpacedQuantiles)
{
  const GrainSizes sizes;
  std::vector<double> radius = draw_radii(sizes, 10, 1);
  std::ranges::sort(radius);
  for (int k = 0; k < 10; ++k)
    EXPECT_NEAR(radius[k], 68e-6 + (k + 0.5) * 6.4e-6, 1e-18);
}

TEST(GrainSizes, NormalHasItsMeanAndDeviation)
{
  const auto [mean, deviation] =
      moments(draw_radii(wide(SizeDistribution::normal), 2000, 1));
  EXPECT_NEAR(mean, 200e-6, 1e-10);             // symmetric: bisection only
  EXPECT_NEAR(deviation, 30e-6, 0.005 * 30e-6); // tails of the quantiles
}

TEST(GrainSizes, LognormalHasItsMeanAndDeviation)
{
  GrainSizes sizes = wide(SizeDistribution::lognormal);
  sizes.maximum_diameter = 500e-6;
  const auto [mean, deviation] = moments(draw_radii(sizes, 2000, 1));
  EXPECT_NEAR(mean, 200e-6, 0.001 * 200e-6);
  EXPECT_NEAR(deviation, 30e-6, 0.01 * 30e-6); // tails of the quantiles
}

TEST(GrainSizes, CutOffsHold)
{
  for (auto distribution :
       {SizeDistribution::normal, SizeDistribution::lognormal}) {
    GrainSizes sizes = wide(distribution);
    sizes.minimum_diameter = 190e-6;
    sizes.maximum_diameter = 205e-6;
    for (double r : draw_radii(sizes, 500, 3)) {
      EXPECT_GE(2 * r, 190e-6);
      EXPECT_LE(2 * r, 205e-6);
    }
  }
}

TEST(GrainSizes, SeedsShuffleTheSameSizes)
{
  const GrainSizes sizes = wide(SizeDistribution::normal);
  std::vector<double> a = draw_radii(sizes, 300, 1),
                      b = draw_radii(sizes, 300, 2);
  EXPECT_EQ(a, draw_radii(sizes, 300, 1));
  EXPECT_NE(a, b);
  std::ranges::sort(a);
  std::ranges::sort(b);
  EXPECT_EQ(a, b);
}

TEST(GrainSizes, OrderKnowsNothingOfSize)
{
  const std::vector<double> radius = draw_radii({}, 2000, 5);
  const double mean = 100e-6, spread = 37e-6; // uniform 68-132 um: 64 / sqrt 3
  double sum = 0;
  for (std::size_t k = 0; k + 1 < radius.size(); ++k)
    sum += (radius[k] - mean) * (radius[k + 1] - mean);
  // Correlation of neighbours: about 1 / sqrt(2000) by chance.
  EXPECT_LT(std::abs(sum / 2000), 0.1 * spread * spread / 4);
}

TEST(GrainSizes, RefusalsNameTheValue)
{
  const auto refusal = [](const GrainSizes &sizes) {
    return message_of<std::invalid_argument>([&] { draw_radii(sizes, 10, 1); });
  };
  GrainSizes sizes = wide(SizeDistribution::normal);
  sizes.mean_diameter = 400e-6;
  EXPECT_NE(refusal(sizes).find("mean diameter = 0.0004"), std::string::npos);
  sizes = wide(SizeDistribution::normal);
  sizes.standard_deviation = 0;
  EXPECT_NE(refusal(sizes).find("standard deviation"), std::string::npos);
  sizes = {};
  sizes.minimum_diameter = -1;
  EXPECT_NE(refusal(sizes).find("minimum diameter = -1"), std::string::npos);
  sizes = {};
  sizes.maximum_diameter = 1e-6;
  EXPECT_NE(refusal(sizes).find("maximum diameter"), std::string::npos);
}

GrainSizes measured(std::vector<SizeShare> table, ShareBasis basis)
{
  GrainSizes sizes;
  sizes.distribution = SizeDistribution::table;
  sizes.table = std::move(table);
  sizes.basis = basis;
  return sizes;
}

/// Diameters of `count` grains, rising.
std::vector<double> diameters(const GrainSizes &sizes, std::size_t count)
{
  std::vector<double> all = draw_radii(sizes, count, 1);
  for (double &d : all)
    d *= 2;
  std::ranges::sort(all);
  return all;
}

const std::vector<SizeShare> sieves{
    {100e-6, 0}, {160e-6, 0.1}, {200e-6, 0.5}, {250e-6, 0.9}, {400e-6, 1}};

TEST(SizeTable, QuantilesByNumberAreThoseOfTheTable)
{
  const auto all = diameters(measured(sieves, ShareBasis::number), 1000);
  EXPECT_GT(all.front(), 100e-6);
  EXPECT_LT(all.back(), 400e-6);
  for (const auto &[diameter, below] : sieves)
    EXPECT_EQ(
        std::ranges::count_if(all, [&](double d) { return d < diameter; }),
        std::lround(1000 * below));
  // Linear between lines; grain k is the quantile (k + 1 / 2) / 1000.
  EXPECT_NEAR(all[300], 180.05e-6, 1e-15);
}

TEST(SizeTable, SharesByVolumeAreThoseOfTheGrainsDrawn)
{
  const auto all = diameters(measured(sieves, ShareBasis::volume), 20000);
  const auto volume = [&](double limit) {
    double sum = 0;
    for (double d : all)
      sum += d < limit ? d * d * d : 0;
    return sum;
  };
  // Steps of the quantiles: a grain of 400 um is 1 / 3000 of the volume.
  constexpr double one_grain = 5e-4;
  for (const auto &[diameter, below] : sieves)
    EXPECT_NEAR(volume(diameter) / volume(1), below, one_grain);
  // Half of a section's volume lies below its middle.
  EXPECT_NEAR(volume(225e-6) / volume(1), 0.7, one_grain);
}

TEST(SizeTable, EqualLinesAreAClassOfEqualGrains)
{
  const std::vector<SizeShare> two{
      {1e-4, 0}, {1e-4, 0.5}, {2e-4, 0.5}, {2e-4, 1}};
  const auto count = [&](ShareBasis basis) {
    const auto all = diameters(measured(two, basis), 900);
    EXPECT_DOUBLE_EQ(all.front(), 1e-4);
    EXPECT_DOUBLE_EQ(all.back(), 2e-4);
    return std::ranges::count_if(all, [](double d) { return d < 1.5e-4; });
  };
  EXPECT_EQ(count(ShareBasis::number), 450);
  // The same volume in grains twice as large: an eighth of the number.
  EXPECT_EQ(count(ShareBasis::volume), 800);
}

TEST(SizeTable, RefusalsNameTheLine)
{
  const auto refusal = [](std::vector<SizeShare> table) {
    return message_of<std::invalid_argument>([&] {
      draw_radii(measured(std::move(table), ShareBasis::number), 10, 1);
    });
  };
  const auto names = [](const std::string &message, const char *part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  names(refusal({{1e-4, 0}}), "lines of the size table = 1");
  names(refusal({{1e-4, 0}, {0.9e-4, 1}}), "diameter in line 2 = 9e-05");
  names(refusal({{1e-4, 0}, {2e-4, 0.6}, {3e-4, 0.5}}),
        "share in line 3 = 0.5");
  names(refusal({{-1e-4, 0}, {2e-4, 1}}), "diameter in line 1 = -0.0001");
  names(refusal({{1e-4, 0.2}, {2e-4, 1}}), "first share");
  names(refusal({{1e-4, 0}, {2e-4, 0.9}}), "last share");
  names(refusal({{1e-4, 0}, {2e-4, std::nan("")}}), "share in line 2 = nan");
}
} // namespace
} // namespace tamp::dem
