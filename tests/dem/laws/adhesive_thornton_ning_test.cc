// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/adhesive_thornton_ning.h>
#include <dem/laws/thornton_ning.h>
#include <tests/dem/laws/law_lanes.h>
#include <tests/dem/laws/law_paths.h>

#include <limits>
#include <numbers>

namespace tamp::dem
{
namespace
{
using Law = AdhesiveThorntonNing;

constexpr double pi = std::numbers::pi;

double square(double x)
{
  return x * x;
}

/// Closed forms of an adhesive pair that yields.
struct Sample {
  double modulus, pressure, adhesion, radius; // E*, p_y, Gamma, R*

  Law law() const { return {modulus, pressure, adhesion}; }
  Dent<double> dent(double largest) const
  {
    const AdhesiveYield yield(modulus, pressure, Jkr(modulus, adhesion));
    return yield.dent(largest, pair_of(radius));
  }
  /// p_y over the pressure that adhesion alone yields under at first touch.
  double hardness() const
  {
    return pressure /
           std::cbrt(2 * modulus * modulus * adhesion / (pi * pi * radius));
  }
  Losses losses() const // as adhesive_yield.h says
  {
    return hardness() > 1.4 ? Losses::grow : Losses::on_closed_paths;
  }
  double pull_off(double r) const { return 1.5 * pi * adhesion * r; }
  double tear_depth(double r) const
  {
    return 0.75 * std::cbrt(square(pi * adhesion / modulus) * r);
  }
  double hertz(double a, double r) const
  {
    return 4 * modulus * a * a * a / (3 * r);
  }
  double elastic(double a, double r) const
  {
    return hertz(a, r) - std::sqrt(8 * pi * adhesion * modulus * a * a * a);
  }
  double overlap(double a, double r) const
  {
    return a * a / r - std::sqrt(2 * pi * adhesion * a / modulus);
  }
  /// Bisection of the pressure in the middle.
  double yield_radius() const
  {
    double low = 1e-9 * radius, high = 1e9 * radius;
    for (int k = 0; k < 200; ++k) {
      const double a = std::sqrt(low * high);
      const double middle = 2 * modulus * a / (pi * radius) -
                            std::sqrt(2 * adhesion * modulus / (pi * a));
      (middle < pressure ? low : high) = a;
    }
    return low;
  }
  double virgin(double a) const
  {
    const double y = yield_radius();
    return elastic(y, radius) + pi * pressure * (a * a - y * y) -
           2 * y * std::sqrt(2 * pi * adhesion * modulus) *
               (std::sqrt(a) - std::sqrt(y));
  }
  double dented_radius(double a) const // R_p*
  {
    const double n1 = hertz(a, radius);
    return radius * n1 / (virgin(a) + std::sqrt(4 * pull_off(radius) * n1));
  }
  double dented_overlap(double a) const // delta_p
  {
    return a * a * (1 / radius - 1 / dented_radius(a));
  }
};

// The last two yield by adhesion alone.
constexpr Sample samples[] = {{1, 0.3, 1e-3, 1},
                              {4e10, 5e8, 0.1, 1e-5},
                              {4e10, 5e8, 0.1, 1e-3},
                              {1e7, 1e6, 0.05, 2e-5},
                              {1e11, 1e9, 1, 1e-6},
                              {1e11, 1e7, 1, 1e-7}};

/// Loaded up to a contact radius on the virgin curve.
Walk<Law> loaded(const Law &law, const Sample &s, double a)
{
  Walk<Law> walk{law, pair_of(s.radius)};
  walk.step(s.overlap(a, s.radius));
  return walk;
}

/// A contact radius beyond yield and first touch.
double yielded(const Sample &s, double ratio)
{
  const double touch =
      std::cbrt(2 * pi * s.adhesion * square(s.radius) / s.modulus);
  return ratio * std::max(s.yield_radius(), touch);
}

TEST(AdhesiveThorntonNing, GivesTheVerificationValues)
{
  constexpr double tolerance = 1e-4; // digits of the values
  const Sample s = samples[0];
  const Law law = s.law();
  const double ay = s.yield_radius();
  EXPECT_NEAR(ay, 0.5259, 1e-4);
  EXPECT_NEAR(square(s.dent(0).yield_root), ay, 1e-12);
  const Walk<Law> walk = loaded(law, s, 2 * ay);
  const double unit = s.pull_off(1);
  EXPECT_NEAR(walk.now.contact_radius, 2 * ay, 1e-12);
  EXPECT_NEAR(walk.now.force / unit, 188.945, 188.945 * tolerance);
  EXPECT_NEAR(walk.now.pull_off / unit, 1.46165, 1.46165 * tolerance);
  EXPECT_NEAR(s.dent(walk.overlap).radius, 1.46165, 1.46165 * tolerance);
}

TEST(AdhesiveThorntonNing, FollowsTheVirginCurve)
{
  constexpr double tolerance = 1e-11; // rounding, and the bisection's
  for (const Sample &s : samples)
    for (const double ratio : {1.0001, 1.1, 2.0, 5.0, 10.0}) {
      const double a = yielded(s, ratio);
      const Law law = s.law();
      const Walk<Law> walk = loaded(law, s, a);
      EXPECT_NEAR(walk.now.contact_radius, a, tolerance * a);
      EXPECT_NEAR(walk.now.force,
                  s.virgin(a),
                  tolerance * (s.hertz(a, s.radius) + walk.now.pull_off));
      EXPECT_TRUE(law.is_plastic(walk.pair, walk.memory));
    }
}

TEST(AdhesiveThorntonNing, UnloadsAsDentedPairAndTearsOff)
{
  for (const Sample &s : samples)
    for (const double ratio : {1.5, 6.0}) {
      const double peak = yielded(s, ratio);
      const double r = s.dented_radius(peak), shift = s.dented_overlap(peak);
      const Law law = s.law();
      Walk<Law> walk = loaded(law, s, peak);
      const double scale = s.hertz(peak, r);
      for (const double share : {0.9, 0.7, 0.5}) {
        const double a = share * peak;
        if (a * a * a < 1.1 * pi * s.adhesion * r * r / (8 * s.modulus))
          continue; // torn before
        walk.step(shift + s.overlap(a, r));
        EXPECT_NEAR(walk.now.contact_radius / a, 1, 1e-10); // rounding
        EXPECT_NEAR(walk.now.force, s.elastic(a, r), 1e-10 * scale);
      }
      const double depth = s.tear_depth(r);
      double least = 0;
      for (int k = 1; k < 4000; ++k) {
        walk.step(shift - depth * k / 4000);
        least = std::min(least, walk.now.force);
      }
      EXPECT_NEAR(least / s.pull_off(r), -1, 1e-6); // of the search
      EXPECT_NEAR(walk.now.pull_off / s.pull_off(r), 1, 1e-10);
      walk.step(shift - depth * (1 - 1e-6));
      EXPECT_NEAR(walk.now.force / s.pull_off(r), -5.0 / 9, 2e-3); // a root
      walk.step(shift - depth * (1 + 1e-6));
      EXPECT_EQ(walk.now.force, 0);
      EXPECT_EQ(walk.now.contact_radius, 0);
      EXPECT_EQ(walk.now.pull_off, 0);
    }
}

TEST(AdhesiveThorntonNing, TouchesAgainWhereDentedSurfacesMeet)
{
  for (const Sample &s : samples) {
    const double peak = yielded(s, 4);
    const double shift = s.dented_overlap(peak), r = s.dented_radius(peak);
    const Law law = s.law();
    Walk<Law> walk = loaded(law, s, peak);
    const double largest = walk.overlap;
    ASSERT_GT(largest, shift);
    walk.step(shift - 1.1 * s.tear_depth(r));
    ASSERT_EQ(walk.now.contact_radius, 0);
    walk.step(shift - 1e-6 * largest);
    EXPECT_EQ(walk.now.contact_radius, 0);
    walk.step(shift + 1e-9 * largest);
    EXPECT_NEAR(walk.now.force / s.pull_off(r), -8.0 / 9, 1e-3); // 1e-9 beyond
  }
}

TEST(AdhesiveThorntonNing, TouchesAtTheLatestWhereOverlapIsNew)
{
  const Sample s = samples[5]; // adhesion alone makes it yield
  const Law law = s.law();
  Walk<Law> walk{law, pair_of(s.radius)};
  const double first = 1e-6 * s.tear_depth(s.radius);
  walk.step(first);
  EXPECT_GT(walk.now.contact_radius, 0);
  EXPECT_TRUE(law.is_plastic(walk.pair, walk.memory));
  ASSERT_LT(s.dent(first).recovery, 0);
  walk.step(-10 * s.radius);
  EXPECT_EQ(walk.now.contact_radius, 0);
  walk.step(0.5 * first);
  EXPECT_EQ(walk.now.contact_radius, 0);
  const NormalMemory<double> before = walk.memory;
  walk.step(1.5 * first);
  EXPECT_GT(walk.now.contact_radius, 0);
  EXPECT_GT(law.lost_at_touch(walk.pair, before), 0);
}

TEST(AdhesiveThorntonNing, ForceIsContinuousOnReloadingAndBeyond)
{
  for (const Sample &s : samples) {
    const Law law = s.law();
    const double peak = s.overlap(yielded(s, 3), s.radius);
    const Dent<double> dent = s.dent(peak);
    const double low = std::max(peak - dent.recovery, 0.0);
    Walk<Law> walk = loaded(law, s, yielded(s, 3));
    const double largest = walk.now.force;
    for (const double target : {low, peak, 0.5 * (low + peak), 1.5 * peak}) {
      const double from = walk.overlap;
      double before = walk.now.force;
      constexpr int parts = 2000;
      for (int k = 1; k <= parts; ++k) {
        walk.step(from + (target - from) * k / parts);
        // At most the steepest slope over a step.
        const double bound = law.steepest_slope(walk.pair, walk.memory) *
                             std::abs(target - from) / parts;
        ASSERT_NEAR(walk.now.force, before, 1.01 * bound);
        before = walk.now.force;
      }
      if (target == peak) {
        EXPECT_NEAR(walk.now.force, largest, 1e-10 * walk.largest_force);
      }
    }
    const double a = walk.now.contact_radius;
    EXPECT_NEAR(walk.now.force, s.virgin(a), 1e-10 * walk.largest_force);
  }
}

TEST(AdhesiveThorntonNing, SlopeIsDerivativeOfForce)
{
  for (const Sample &s : samples) {
    const Law law = s.law();
    const Walk<Law> walk = loaded(law, s, yielded(s, 3));
    const double peak = walk.overlap;
    expect_slope(walk, peak, true);
    expect_slope(walk, 1.3 * peak, true);
    const double rest = peak - s.dent(peak).recovery;
    for (const double share : {0.3, 0.8})
      expect_slope(walk, rest + share * (peak - rest), false);
  }
}

TEST(AdhesiveThorntonNing, WorkIsStoredOrLost)
{
  for (const Sample &s : samples)
    for (const double ratio : {0.9, 2.0, 6.0}) {
      const double reach = std::abs(s.overlap(yielded(s, ratio), s.radius));
      expect_work_in_ledger(s.law(), s.radius, reach);
    }
}

TEST(AdhesiveThorntonNing, LosesAsItTouchesAndTears)
{
  for (const Sample &s : samples) {
    const Law law = s.law();
    double lost = 0;
    for (double ratio = 1.2; ratio < 10; ratio *= 1.2) {
      const Walk<Law> walk = loaded(law, s, yielded(s, ratio));
      EXPECT_GT(law.lost_at_touch(walk.pair, walk.memory), 0);
      EXPECT_GT(law.lost_at_tear(walk.pair, walk.memory), 0);
      const double more = law.energy(0, walk.pair, walk.memory).dissipated;
      if (s.losses() == Losses::grow) {
        EXPECT_GT(more, lost);
      }
      lost = more;
    }
  }
}

TEST(AdhesiveThorntonNing, WithoutAdhesionIsThorntonNing)
{
  constexpr double tolerance = 1e-9; // promised
  const double modulus = 4e10, pressure = 5e8;
  const ThorntonNing plain(modulus, pressure);
  const Law law(modulus, pressure, 0);
  for (const double radius : {1e-6, 1e-3, 1.0})
    for (const double reach : {1e-4, 1e-2, 0.1}) {
      const PairShape<double> pair = pair_of(radius);
      NormalMemory<double> memory{reach * radius, 0};
      const double peak = plain(reach * radius, pair, memory).force;
      for (double share = -0.05; share <= 1; share += 0.05) {
        for (const double touched : {0.0, 1.0}) {
          memory.contact_radius = touched;
          const auto expected = plain(share * reach * radius, pair, memory);
          const auto found = law(share * reach * radius, pair, memory);
          EXPECT_NEAR(found.force, expected.force, tolerance * peak);
          EXPECT_NEAR(square(found.contact_radius),
                      square(expected.contact_radius),
                      tolerance * radius * reach * radius);
          EXPECT_EQ(found.pull_off, 0);
        }
      }
      EXPECT_EQ(law.is_plastic(pair, memory), plain.is_plastic(pair, memory));
      const double lost = plain.energy(0, pair, memory).dissipated;
      EXPECT_NEAR(law.energy(0, pair, memory).dissipated,
                  lost,
                  tolerance * (lost + peak * reach * radius));
    }
}

TEST(AdhesiveThorntonNing, WithoutYieldingIsJkr)
{
  constexpr double tolerance = 1e-12; // rounding
  for (const Sample &s : samples)
    for (const double pressure :
         {1e2 * s.modulus, std::numeric_limits<double>::infinity()}) {
      const Law law(s.modulus, pressure, s.adhesion);
      const Jkr jkr(s.modulus, s.adhesion);
      const PairShape<double> pair = pair_of(s.radius);
      const double unit = s.tear_depth(s.radius);
      for (const double overlap : {-1.1, -0.9, -0.1, 0.1, 1.0, 30.0}) {
        for (const double touched : {0.0, 1.0}) {
          NormalMemory<double> one{50 * unit, touched}, other = one;
          const auto expected = jkr(overlap * unit, pair, one);
          const auto found = law(overlap * unit, pair, other);
          EXPECT_NEAR(found.force,
                      expected.force,
                      tolerance *
                          (std::abs(expected.force) + expected.pull_off));
          EXPECT_NEAR(found.contact_radius,
                      expected.contact_radius,
                      tolerance * expected.contact_radius);
          EXPECT_EQ(law.energy(overlap * unit, pair, one).dissipated, 0);
          EXPECT_FALSE(law.is_plastic(pair, one));
        }
      }
    }
}

/// A fifth without adhesion; where p_y would be too low, the lowest that may
/// be.
Sample any_sample(RandomNumbers &random)
{
  const double modulus = std::pow(10.0, 6 + 6 * random.next());
  const double some = std::pow(10.0, -4 + 4 * random.next());
  const double pressure = modulus * std::pow(10.0, -4 + 4 * random.next());
  const double adhesion = random.next() > 0.2 ? some : 0;
  const double radius = std::pow(10.0, -6 + 6 * random.next());
  const double least = AdhesiveYield::least_pressure(modulus, adhesion, radius);
  return {modulus, std::max(pressure, least), adhesion, radius};
}

TEST(AdhesiveThorntonNing, GivesNoEnergyAwayOnRandomPaths)
{
  RandomNumbers random(7);
  int broken = 0, growing = 0, at_the_bound = 0;
  for (int path = 0; path < 100000; ++path) {
    const Sample s = any_sample(random);
    growing += s.losses() == Losses::grow;
    at_the_bound += s.hardness() < 0.4251;
    broken += count_broken(s.law(), s.radius, s.losses(), random);
  }
  EXPECT_EQ(broken, 0);
  EXPECT_GT(growing, 50000);
  EXPECT_GT(at_the_bound, 1000);
}

TEST(AdhesiveThorntonNing, IsTheSameInPacksAndInFloat)
{
  expect_same_in_packs_and_float(
      [](RandomNumbers &random) { return any_sample(random).law(); });
}
} // namespace
} // namespace tamp::dem
