// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/hertz.h>
#include <tests/dem/laws/impact.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace tamp::dem
{
namespace
{
using test::equal_pair;

struct ElasticImpact {
  const char *name;
  double modulus, poisson, density; // of the grains
  double radius, speed;
  bool plane; // sphere on a rigid plane, or two spheres
  double force, overlap, duration;
};

// Published inputs of Chung & Ooi (2011), tests 1 and 2.
constexpr std::array<ElasticImpact, 4> elastic_impacts = {{
    {"glass", 48e9, .2, 2800, .01, 20, false, 10697, 274.11e-6, 40.34e-6},
    {"limestone", 20e9, .25, 2500, .01, 20, false, 7108.2, 368.30e-6, 54.20e-6},
    {"Al alloy", 70e9, .3, 2699, .1, .2, true, 11370, 49.717e-6, 731.7e-6},
    {"Mg alloy", 40e9, .35, 1800, .1, .2, true, 7232.7, 52.123e-6, 767.1e-6},
}};

TEST(HertzImpact, AgreesWithClosedFormAndChungAndOoi)
{
  constexpr double tolerance = 2e-3; // digits of the published values
  for (const ElasticImpact &c : elastic_impacts) {
    SCOPED_TRACE(c.name);
    const double share = c.plane ? 1 : 0.5;
    const double sphere = c.modulus / (1 - c.poisson * c.poisson);
    const double radius = share * c.radius, modulus = share * sphere;
    const double mass =
        share * 4.0 / 3 * std::numbers::pi * std::pow(c.radius, 3) * c.density;
    const test::Impact found = test::collide(
        Hertz{modulus}, equal_pair(radius, 1 / mass), modulus, c.speed);
    EXPECT_NEAR(found.largest_force, c.force, tolerance * c.force);
    EXPECT_NEAR(found.largest_overlap, c.overlap, tolerance * c.overlap);
    EXPECT_NEAR(found.duration, c.duration, tolerance * c.duration);
    EXPECT_NEAR(found.rebound, 1, 1e-4); // elastic; error of the integration
    const double overlap = std::pow(15 * mass * c.speed * c.speed /
                                        (16 * modulus * std::sqrt(radius)),
                                    0.4);
    EXPECT_NEAR(found.largest_overlap, overlap, 1e-4 * overlap);
  }
}

TEST(Hertz, EnergyIsWorkOfForce)
{
  const Hertz law{4e10};
  const PairShape<double> pair = equal_pair(1e-4);
  const double end = 3e-6;
  constexpr int parts = 4000;
  double work = 0;
  NormalMemory<double> memory = {0, 0};
  for (int k = 0; k < parts; ++k)
    work += law((k + 0.5) * end / parts, pair, memory).force * end / parts;
  const NormalEnergy energy = law.energy(end, pair, memory);
  EXPECT_NEAR(energy.elastic, work, 1e-6 * work); // midpoint rule
  EXPECT_EQ(energy.dissipated, 0);
}

TEST(Hertz, OpenContactHasNoForceAndDoesNotTouch)
{
  NormalMemory<double> memory = {3e-6, 1e-6};
  const NormalAnswer<double> answer =
      Hertz{4e10}(-1e-9, equal_pair(1e-4), memory);
  EXPECT_EQ(answer.force, 0);
  EXPECT_EQ(answer.contact_radius, 0);
  EXPECT_EQ(answer.pull_off, 0);
}

TEST(Hertz, SlopeIsDerivativeOfForce)
{
  const Hertz law{4e10};
  const PairShape<double> pair = equal_pair(1e-4);
  const double at = 1e-6, step = 1e-10;
  NormalMemory<double> memory = {1, 0};
  const double slope = (law(at + step, pair, memory).force -
                        law(at - step, pair, memory).force) /
                       (2 * step);
  EXPECT_NEAR(law.loading_slope(at, pair, memory), slope, 1e-6 * slope);
  EXPECT_NEAR(law.steepest_slope(pair, {at, 0}), slope, 1e-6 * slope);
}
} // namespace
} // namespace tamp::dem
