// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/pair_laws.h>
#include <tests/dem/laws/impact.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <variant>

namespace tamp::dem
{
namespace
{
using test::equal_pair;
constexpr double pi = std::numbers::pi;

struct PlasticImpact {
  double speed; // over the yield speed
  double restitution, radius_ratio, permanent_share;
};

constexpr std::array<PlasticImpact, 10> plastic_impacts = {{
    {1, 1, 1, 0},
    {1.5, .971239, 1.0336, .0325},
    {2, .930626, 1.0916, .0839},
    {3, .862740, 1.2169, .1782},
    {5, .773337, 1.4505, .3106},
    {10, .658558, 1.9256, .4807},
    {20, .557109, 2.6353, .6205},
    {50, .444606, 4.0837, .7551},
    {100, .374299, 5.7362, .8257},
    {1000, .210701, 18.028, .9445},
}};

/// Thornton (1997), closed form; u = v_y / v.
double thornton_restitution(double u)
{
  const double rest = 1.2 - u * u / 5;
  return std::sqrt(6 * std::sqrt(3.0) / 5) * std::sqrt(1 - u * u / 6) *
         std::pow(u / (u + 2 * std::sqrt(rest)), 0.25);
}

TEST(ThorntonNingImpact, RestitutionAgreesWithClosedFormAndTable)
{
  constexpr double tolerance = 1e-3; // last digits of the table
  const double radius = 0.7, mass = 1.3, modulus = 2, pressure = 3e-3;
  const ThorntonNing law(modulus, pressure);
  const PairShape<double> pair = equal_pair(radius, 1 / mass);
  const double yield_speed =
      std::pow(pi / (2 * modulus), 2) *
      std::sqrt(8 * pi * std::pow(radius, 3) / (15 * mass)) *
      std::pow(pressure, 2.5);
  for (const PlasticImpact &c : plastic_impacts) {
    SCOPED_TRACE(c.speed);
    const test::Impact found =
        test::collide(law, pair, modulus, c.speed * yield_speed);
    EXPECT_NEAR(found.rebound, c.restitution, tolerance);
    EXPECT_NEAR(found.rebound, thornton_restitution(1 / c.speed), tolerance);

    // On the unloading branch a^2 = R_p* (delta - delta_p).
    const double top = found.largest_overlap, low = 0.99 * top;
    NormalMemory<double> memory = {top, 0};
    const double a = law(top, pair, memory).contact_radius;
    const double b = law(low, pair, memory).contact_radius;
    const double unloading_radius = (a * a - b * b) / (top - low);
    EXPECT_NEAR(
        unloading_radius / radius, c.radius_ratio, tolerance * c.radius_ratio);
    EXPECT_NEAR(
        1 - a * a / unloading_radius / top, c.permanent_share, tolerance);
  }
}

/// Grains of R = 100 um, E = 70 GPa, nu = 0.3 with p_y = 0.5 GPa.
struct YieldingPair : testing::Test {
  GrainMaterial material{70e9, 0.3, 2650, 0.5e9};
  double radius = 50e-6;
  double modulus = pair_material(material, material).effective_modulus;
  PairShape<double> pair = equal_pair(radius);
  ThorntonNing law =
      std::get<ThorntonNing>(pair_laws({}, material, material).normal);
  double yield = law.yield_overlap(pair);
  double slope = pi * material.limiting_pressure * radius;
  NormalMemory<double> memory = {0, 0};

  double force(double overlap) { return law(overlap, pair, memory).force; }
};

TEST(ThorntonNing, GrainsApartDoNotTouchWhateverTheirSize)
{
  const ThorntonNing law(4e10, 5e8);
  for (double radius = 1e-6; radius < 1e-2; radius *= 1.01)
    for (double overlap : {0.0, -1e-9}) {
      NormalMemory<double> memory = {0, 0};
      const NormalAnswer<double> answer =
          law(overlap, equal_pair(radius), memory);
      EXPECT_EQ(answer.force, 0) << radius;
      EXPECT_EQ(answer.contact_radius, 0) << radius;
    }
}

TEST_F(YieldingPair, FirstYieldsWhereThorntonSays)
{
  constexpr double tolerance = 1e-3; // digits of the published values
  const NormalAnswer<double> answer = law(yield, pair, memory);
  EXPECT_NEAR(yield, 20.85e-9, tolerance * 20.85e-9);
  EXPECT_NEAR(answer.contact_radius, 1.021e-6, tolerance * 1.021e-6);
  EXPECT_NEAR(answer.force, 1.092e-3, tolerance * 1.092e-3);
  EXPECT_EQ(answer.pull_off, 0);
  EXPECT_NEAR(law.loading_slope(yield, pair, memory), 78.54e3, 78.54);
  const double closed = std::pow(pi, 3) * radius * radius *
                        std::pow(material.limiting_pressure, 3) /
                        (6 * std::pow(modulus, 2));
  EXPECT_NEAR(answer.force, closed, 1e-12 * closed);
}

TEST_F(YieldingPair, IsHertzBeforeYield)
{
  const Hertz hertz{modulus};
  for (double share : {0.0, 0.1, 0.5, 0.999}) {
    NormalMemory<double> one = {0, 0}, same = {0, 0};
    const auto a = law(share * yield, pair, one);
    const auto b = hertz(share * yield, pair, same);
    const double size = law.virgin_force(yield, pair);
    EXPECT_NEAR(a.force, b.force, 1e-12 * size);
    EXPECT_NEAR(a.contact_radius, b.contact_radius, 1e-12 * radius);
    EXPECT_EQ(one.largest_overlap, same.largest_overlap);
    EXPECT_FALSE(law.is_plastic(pair, one));
  }
}

TEST_F(YieldingPair, SlopeIsContinuousAtYield)
{
  const double step = 1e-5 * yield;
  const auto virgin = [&](double overlap) {
    NormalMemory<double> fresh = {0, 0};
    return law(overlap, pair, fresh).force;
  };
  const double below = (virgin(yield) - virgin(yield - step)) / step;
  const double above = (virgin(yield + step) - virgin(yield)) / step;
  EXPECT_NEAR(below, slope, 1e-5 * slope); // Hertz curves by step / (4 yield)
  EXPECT_NEAR(above, slope, 1e-8 * slope); // straight; round-off of the step
  EXPECT_NEAR(virgin(5 * yield), virgin(yield) + 4 * slope * yield, 1e-12);
}

TEST_F(YieldingPair, SlopesAreDerivativesOfUnloading)
{
  const double top = 7 * yield, step = 1e-5 * top;
  memory.largest_overlap = top;
  EXPECT_TRUE(law.is_plastic(pair, memory));
  const double below = (force(top) - force(top - step)) / step;
  // rho^(3/2) curves by step / (4 (delta* - delta_p)).
  EXPECT_NEAR(law.steepest_slope(pair, memory), below, 1e-5 * below);
  const double at = 0.9 * top;
  const double inside = (force(at + step) - force(at - step)) / (2 * step);
  EXPECT_NEAR(law.loading_slope(at, pair, memory), inside, 1e-8 * inside);
}

TEST_F(YieldingPair, ReloadingRetracesUnloading)
{
  const double top = 7 * yield;
  memory.largest_overlap = top;
  const double peak = force(top), low = force(0.8 * top);
  EXPECT_LT(low, peak);
  force(0);
  EXPECT_EQ(force(0.8 * top), low);
  EXPECT_EQ(force(top), peak);
  EXPECT_EQ(memory.largest_overlap, top);
  EXPECT_NEAR(force(1.1 * top), peak + 0.1 * slope * top, 1e-12 * peak);
  EXPECT_EQ(memory.largest_overlap, 1.1 * top);
}

TEST_F(YieldingPair, NoForceAtPermanentOverlap)
{
  const double top = 7 * yield;
  memory.largest_overlap = top;
  const NormalAnswer<double> answer = law(top, pair, memory);
  const double a = answer.contact_radius;
  const double unloading_radius = 4 * modulus * a * a * a / (3 * answer.force);
  const double permanent = top - a * a / unloading_radius;
  EXPECT_GT(permanent, 0);
  EXPECT_EQ(force(0.9999 * permanent), 0);
  EXPECT_EQ(law(0.9999 * permanent, pair, memory).contact_radius, 0);
  EXPECT_GT(force(1.0001 * permanent), 0);
}

TEST_F(YieldingPair, EnergyIsWorkOfForceAlongLoadingAndUnloading)
{
  const double top = 6 * yield;
  constexpr int parts = 20000;
  double work = 0;
  const auto travel = [&](double from, double to) {
    for (int k = 0; k < parts; ++k)
      work +=
          force(from + (k + 0.5) / parts * (to - from)) * (to - from) / parts;
  };
  const auto kept = [&](double overlap) {
    const NormalEnergy energy = law.energy(overlap, pair, memory);
    return energy.elastic + energy.dissipated;
  };
  travel(0, top);
  const double loading = work, tolerance = 1e-6 * loading; // midpoint rule
  memory.largest_overlap = top; // the last midpoint lies half a part below
  EXPECT_NEAR(kept(top), loading, tolerance);
  travel(top, 0.7 * top);
  EXPECT_NEAR(kept(0.7 * top), work, tolerance);
  travel(0.7 * top, 0);
  EXPECT_NEAR(kept(0), work, tolerance);

  const double peak = force(top);
  const double yield_force = law.virgin_force(yield, pair);
  const double above = top - yield;
  const double given = 0.4 * yield_force * yield + yield_force * above +
                       0.5 * slope * above * above;
  EXPECT_NEAR(loading, given, tolerance);
  const double recovered =
      0.75 * peak / modulus / std::sqrt(radius * top); // delta* - delta_p
  EXPECT_NEAR(law.energy(0, pair, memory).dissipated,
              given - 0.4 * peak * recovered,
              1e-12 * given);
}
} // namespace
} // namespace tamp::dem
