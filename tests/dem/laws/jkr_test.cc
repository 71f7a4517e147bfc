// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/hertz.h>
#include <dem/laws/jkr.h>
#include <tests/dem/laws/law_lanes.h>
#include <tests/dem/laws/law_paths.h>

#include <numbers>

namespace tamp::dem
{
namespace
{
constexpr double pi = std::numbers::pi;

/// Closed forms of an adhesive pair.
struct Sample {
  double modulus, adhesion, radius; // E* [Pa], Gamma [J/m2], R* [m]

  Jkr law() const { return {modulus, adhesion}; }
  double pull_off() const { return 1.5 * pi * adhesion * radius; }
  double tear_overlap() const
  {
    return -0.75 * std::cbrt(square(pi * adhesion / modulus) * radius);
  }
  double tear_radius() const
  {
    return std::cbrt(pi * adhesion * square(radius) / (8 * modulus));
  }
  double overlap(double a) const
  {
    return a * a / radius - std::sqrt(2 * pi * adhesion * a / modulus);
  }
  double force(double a) const
  {
    return 4 * modulus * a * a * a / (3 * radius) -
           std::sqrt(8 * pi * adhesion * modulus * a * a * a);
  }
  double lost() const
  {
    return std::cbrt(std::pow(adhesion, 5) * std::pow(radius, 4) /
                     square(modulus));
  }
  static double square(double x) { return x * x; }
};

constexpr Sample samples[] = {{1e11, 0.2, 1e-6},
                              {1e11, 0.2, 1e-4},
                              {1e7, 0.05, 2e-5},
                              {1, 1e-3, 1},
                              {2e10, 1e-4, 3},
                              {1e11, 1, 1e-9}};

double force_at(const Sample &s, double overlap, bool touched)
{
  NormalMemory<double> memory{0, touched ? 1.0 : 0.0};
  return s.law()(overlap, pair_of(s.radius), memory).force;
}

TEST(CubeRoot, IsExactToItsPromise)
{
  for (double x = 1e-6; x < 1e6; x *= 1.07) {
    const double tolerance = x > 1e-3 && x < 1e3 ? 1e-9 : 3e-4; // promised
    EXPECT_NEAR(quick_cube_root(x) / std::cbrt(x), 1, tolerance) << x;
  }
}

TEST(JkrRoot, SolvesTheQuartic)
{
  for (const double pull : {3.9, 4.0, 4.1})
    for (double push = -0.4724; push < 1e9; // the quartic has its least at
         push = push < 3 ? push + 0.01 : push * 1.1) { // -3/4 (pull^4/4)^(1/3)
      const double scaled = push * std::pow(pull, 4.0 / 3);
      const double t = jkr_root(pull, scaled);
      const double sum = t * t * t * t + pull * t + std::abs(scaled);
      const double rest = t * t * t * t - pull * t - scaled;
      EXPECT_NEAR(rest, 0, 1e-14 * sum) << pull << " " << push; // rounding
    }
  for (const double none : {-3.5, -5.0, -1e9, -1e300})
    EXPECT_TRUE(std::isfinite(jkr_root(4.0, none))) << none;
}

TEST(Jkr, HasItsForcesAtTouchPullOffAndTear)
{
  constexpr double tolerance = 1e-6; // of the search for the least force
  for (const Sample &s : samples) {
    const double tear = s.tear_overlap();
    EXPECT_NEAR(force_at(s, 0, true) / s.pull_off(), -8.0 / 9, 1e-12);
    EXPECT_NEAR(force_at(s, tear * (1 - 1e-13), true) / s.pull_off(),
                -5.0 / 9,
                tolerance); // a square root of the distance
    EXPECT_EQ(force_at(s, tear * (1 + 1e-12), true), 0);
    double least = 0;
    for (int k = 1; k < 4000; ++k)
      least = std::min(least, force_at(s, tear * k / 4000, true));
    EXPECT_NEAR(least / s.pull_off(), -1, tolerance);
    NormalMemory<double> memory{0, 0};
    EXPECT_NEAR(s.law()(1e-3 * s.radius, pair_of(s.radius), memory).pull_off,
                s.pull_off(),
                1e-14 * s.pull_off());
  }
}

TEST(Jkr, GivesForceAndRadiusOfTheClosedForm)
{
  constexpr double tolerance = 1e-13; // rounding
  for (const Sample &s : samples)
    for (double ratio = 1.1; ratio < 1e4; ratio *= 1.3) {
      const double a = ratio * s.tear_radius();
      NormalMemory<double> memory{0, 1};
      const auto answer = s.law()(s.overlap(a), pair_of(s.radius), memory);
      EXPECT_NEAR(answer.contact_radius / a, 1, 10 * tolerance) << ratio;
      EXPECT_NEAR(answer.force,
                  s.force(a),
                  50 * tolerance * (s.force(a) + 2 * s.pull_off()));
    }
}

TEST(Jkr, TouchesAboveZeroAndHoldsOnDownToTheTear)
{
  for (const Sample &s : samples) {
    const Jkr law = s.law();
    const double tear = s.tear_overlap();
    Walk<Jkr> walk{law, pair_of(s.radius)};
    walk.step(0.5 * tear);
    EXPECT_EQ(walk.now.contact_radius, 0);
    walk.step(0);
    EXPECT_EQ(walk.now.contact_radius, 0);
    walk.step(-1e-9 * tear);
    EXPECT_GT(walk.now.contact_radius, 0);
    EXPECT_NEAR(walk.now.force / s.pull_off(), -8.0 / 9, 1e-8); // 1e-9 beyond
    walk.step(0.999 * tear);
    EXPECT_GT(walk.now.contact_radius, 0.9 * s.tear_radius());
    walk.step(1.001 * tear);
    EXPECT_EQ(walk.now.contact_radius, 0);
    EXPECT_EQ(walk.now.force, 0);
    EXPECT_EQ(walk.now.pull_off, 0);
    walk.step(0.5 * tear);
    EXPECT_EQ(walk.now.contact_radius, 0);
  }
}

TEST(Jkr, SlopeIsDerivativeOfForce)
{
  for (const Sample &s : samples) {
    const Jkr law = s.law();
    const double unit = -s.tear_overlap();
    Walk<Jkr> walk{law, pair_of(s.radius), {unit, 1}};
    for (const double at : {-0.9, -0.5, 0.1, 1.0, 30.0})
      expect_slope(walk, at * unit, false);
    walk.memory.largest_overlap = 30 * unit;
    for (double at = 0; at < 30; at += 0.1)
      EXPECT_LE(law.loading_slope(at * unit, walk.pair, walk.memory),
                law.steepest_slope(walk.pair, walk.memory));
  }
}

TEST(Jkr, LosesAsItTouchesAndTearsWhatIsKnown)
{
  for (const Sample &s : samples) {
    const Jkr law = s.law();
    const NormalMemory<double> memory{0, 0};
    const double lost = law.lost_at_touch(pair_of(s.radius), memory) +
                        law.lost_at_tear(pair_of(s.radius), memory);
    EXPECT_NEAR(lost / s.lost(), 7.092, 1e-4 * 7.092); // its digits
    // v_s^2 = 2 W_s / m*
    EXPECT_NEAR(2 * lost / s.lost(), 14.184, 1e-4 * 14.184);
  }
}

TEST(Jkr, WorkIsStoredOrLost)
{
  for (const Sample &s : samples)
    for (const double reach : {3.0, 50.0})
      expect_work_in_ledger(s.law(), s.radius, -reach * s.tear_overlap());
}

TEST(Jkr, WithoutAdhesionIsHertz)
{
  constexpr double tolerance = 1e-9; // promised
  for (const double radius : {1e-6, 1e-3, 1.0})
    for (const double share : {1e-4, 1e-2, 0.1}) {
      NormalMemory<double> memory{0, 0};
      const auto pair = pair_of(radius);
      const auto hertz = Hertz{1e11}(share * radius, pair, memory);
      const auto jkr = Jkr(1e11, 0)(share * radius, pair, memory);
      EXPECT_NEAR(jkr.force / hertz.force, 1, tolerance);
      EXPECT_NEAR(jkr.contact_radius / hertz.contact_radius, 1, tolerance);
      EXPECT_EQ(jkr.pull_off, 0);
      memory.contact_radius = jkr.contact_radius;
      const auto apart = Jkr(1e11, 0)(-1e-9 * radius, pair, memory);
      EXPECT_EQ(apart.force, 0);
      EXPECT_EQ(apart.contact_radius, 0);
    }
}

Jkr any_law(RandomNumbers &random)
{
  const double modulus = std::pow(10.0, 6 + 6 * random.next());
  const double adhesion = std::pow(10.0, -4 + 4 * random.next());
  return {modulus, random.next() > 0.2 ? adhesion : 0};
}

TEST(Jkr, GivesNoEnergyAwayOnRandomPaths)
{
  expect_no_gain_on_random_paths(any_law);
}

TEST(Jkr, IsTheSameInPacksAndInFloat)
{
  expect_same_in_packs_and_float(any_law);
}
} // namespace
} // namespace tamp::dem
