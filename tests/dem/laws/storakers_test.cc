// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/storakers.h>
#include <tests/dem/laws/law_lanes.h>
#include <tests/dem/laws/law_paths.h>

#include <numbers>

namespace tamp::dem
{
namespace
{
constexpr double pi = std::numbers::pi;
constexpr double modulus = 4e10, pressure = 6e8, radius = 5e-5;

TEST(Storakers, YieldsUnderItsMeanPressureFromFirstTouch)
{
  const Storakers law(modulus, pressure);
  Walk<Storakers> walk{law, pair_of(radius)};
  for (double overlap = 1e-12; overlap < 1e-5; overlap *= 3) {
    walk.step(overlap);
    const double a = walk.now.contact_radius;
    // c^2 = 1.43, sigma_0 = p_y / 3
    EXPECT_NEAR(a * a / (2 * 1.43 * radius * overlap), 1, 1e-14);
    EXPECT_NEAR(walk.now.force /
                    (6 * pi * 1.43 * pressure / 3 * radius * overlap),
                1,
                1e-14);
    EXPECT_NEAR(walk.now.force / (pi * a * a * pressure), 1, 1e-14);
    EXPECT_TRUE(law.is_plastic(walk.pair, walk.memory));
  }
}

TEST(Storakers, UnloadsAsMesarovicAndJohnson)
{
  const Storakers law(modulus, pressure);
  const double peak = 2e-6, a_peak = std::sqrt(2 * 1.43 * radius * peak);
  Walk<Storakers> walk{law, pair_of(radius)};
  walk.step(peak);
  const double largest = walk.now.force;
  for (const double x : {0.99, 0.7, 0.4, 0.1, 0.0}) {
    const double root = std::sqrt(1 - x * x);
    walk.step(peak - 2 * pressure * a_peak / modulus * root);
    // Rounding of an overlap that is the difference of larger ones.
    EXPECT_NEAR(walk.now.contact_radius, x * a_peak, 1e-7 * a_peak);
    EXPECT_NEAR(walk.now.force,
                largest * 2 / pi * (std::asin(x) - x * root),
                1e-13 * largest);
  }
  EXPECT_GT(walk.overlap, 0.2 * peak); // a permanent overlap
  walk.step(0.5 * walk.overlap);
  EXPECT_EQ(walk.now.force, 0);
  EXPECT_EQ(walk.now.contact_radius, 0);
  EXPECT_NEAR(law.steepest_slope(walk.pair, walk.memory),
              2 * modulus * a_peak,
              1e-12 * modulus * a_peak);
}

TEST(Storakers, ForceIsContinuousOnReloadingAndBeyond)
{
  const Storakers law(modulus, pressure);
  for (const double peak : {1e-9, 1e-7, 3e-6}) {
    Walk<Storakers> walk{law, pair_of(radius)};
    walk.step(peak);
    const double largest = walk.now.force;
    for (const double target : {0.2, 1.0, 0.6, 1.2}) {
      const double from = walk.overlap / peak;
      double before = walk.now.force;
      for (int k = 1; k <= 1000; ++k) {
        walk.step(peak * (from + (target - from) * k / 1000));
        // At most the steepest slope over the step, w > peak / 8.
        EXPECT_NEAR(walk.now.force, before, 2e-2 * largest);
        before = walk.now.force;
      }
      if (target == 1.0) {
        EXPECT_NEAR(walk.now.force, largest, 1e-12 * largest); // retraced
      }
    }
    EXPECT_NEAR(walk.now.force, 1.2 * largest, 1e-12 * largest);
    walk.step(-peak);
    EXPECT_EQ(walk.now.force, 0);
  }
}

TEST(Storakers, SmallContactsPartWhereTheyStopToOverlap)
{
  const Storakers law(modulus, pressure);
  const double peak = 1e-9; // w would be some 20 nm
  Walk<Storakers> walk{law, pair_of(radius)};
  walk.step(peak);
  const double largest = walk.now.force;
  walk.step(1e-3 * peak);
  EXPECT_GT(walk.now.force, 0);
  EXPECT_LT(walk.now.force, 1e-3 * largest);
  walk.step(0);
  EXPECT_EQ(walk.now.force, 0);
}

TEST(Storakers, SlopeIsDerivativeOfForce)
{
  const Storakers law(modulus, pressure);
  for (const double peak : {1e-9, 1e-6}) {
    const Walk<Storakers> walk{law, pair_of(radius), {peak, 0}};
    for (const double share : {0.9, 0.97, 0.99})
      expect_slope(walk, share * peak, false);
    expect_slope(walk, peak, true);
    expect_slope(walk, 1.5 * peak, true);
  }
}

TEST(Storakers, WorkIsStoredOrLost)
{
  const Storakers law(modulus, pressure);
  for (const double reach : {2e-9, 1e-7, 1e-5})
    expect_work_in_ledger(law, radius, reach);
}

Storakers any_law(RandomNumbers &random)
{
  const double stiff = std::pow(10.0, 6 + 6 * random.next());
  return {stiff, stiff * std::pow(10.0, -5 + 4 * random.next())};
}

TEST(Storakers, GivesNoEnergyAwayOnRandomPaths)
{
  expect_no_gain_on_random_paths(any_law);
}

TEST(Storakers, IsTheSameInPacksAndInFloat)
{
  expect_same_in_packs_and_float(any_law);
}
} // namespace
} // namespace tamp::dem
