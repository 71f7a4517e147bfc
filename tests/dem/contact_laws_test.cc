// SPDX-License-Identifier: BSD-3-Clause
#include <dem/grain_material.h>
#include <dem/laws/hertz.h>
#include <dem/laws/law_choice.h>
#include <dem/laws/mindlin.h>
#include <dem/laws/thornton_ning.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace tamp::dem
{
namespace
{
constexpr double pi = std::numbers::pi;

/// What a head-on impact of two grains comes to.
struct Impact {
  double largest_force = 0, largest_overlap = 0, duration = 0, rebound = 0;
};

/// Integrates m* delta'' = -N by velocity Verlet, with a step that follows the
/// stiffness of the contact.
template <class Law>
Impact collide(const Law &law, double reduced_radius, double mass, double speed)
{
  constexpr double step_share = 2e-3; // of 1 / frequency; errors go with the
                                      // square of it
  const auto frequency = [&](double overlap) {
    return std::sqrt(law.steepest_slope(reduced_radius, overlap) / mass);
  };
  // Enough overlap for a first step length: a thousandth of the elastic one.
  const double small =
      1e-3 * std::pow(mass * speed * speed /
                          (law.effective_modulus * std::sqrt(reduced_radius)),
                      0.4);
  Impact impact;
  double overlap = 0, velocity = speed, force = 0, largest = 0;
  while (overlap > 0 || velocity > 0) {
    const double step = step_share / frequency(std::max(largest, small));
    velocity -= 0.5 * step * force / mass;
    overlap += step * velocity;
    force = law(overlap, reduced_radius, largest).force;
    velocity -= 0.5 * step * force / mass;
    impact.duration += step;
    impact.largest_force = std::max(impact.largest_force, force);
    if (velocity < 0 && force == 0)
      break;
  }
  impact.largest_overlap = largest;
  impact.rebound = -velocity / speed;
  return impact;
}

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
        share * 4.0 / 3 * pi * std::pow(c.radius, 3) * c.density;
    const Impact found = collide(Hertz{modulus}, radius, mass, c.speed);
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
  const double radius = 1e-4, end = 3e-6;
  constexpr int parts = 4000;
  double work = 0, largest = 0;
  for (int k = 0; k < parts; ++k)
    work += law((k + 0.5) * end / parts, radius, largest).force * end / parts;
  const NormalEnergy energy = law.energy(end, radius, largest);
  EXPECT_NEAR(energy.elastic, work, 1e-6 * work); // midpoint rule
  EXPECT_EQ(energy.dissipated, 0);
  EXPECT_EQ(law(-1e-9, radius, largest).force, 0);
}

TEST(Hertz, SlopeIsDerivativeOfForce)
{
  const Hertz law{4e10};
  const double radius = 1e-4, at = 1e-6, step = 1e-10;
  double largest = 1;
  const double slope = (law(at + step, radius, largest).force -
                        law(at - step, radius, largest).force) /
                       (2 * step);
  EXPECT_NEAR(law.loading_slope(at, radius, at), slope, 1e-6 * slope);
}

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
  const ThorntonNing law{modulus, pressure};
  const double yield_speed =
      std::pow(pi / (2 * modulus), 2) *
      std::sqrt(8 * pi * std::pow(radius, 3) / (15 * mass)) *
      std::pow(pressure, 2.5);
  for (const PlasticImpact &c : plastic_impacts) {
    SCOPED_TRACE(c.speed);
    const Impact found = collide(law, radius, mass, c.speed * yield_speed);
    EXPECT_NEAR(found.rebound, c.restitution, tolerance);
    EXPECT_NEAR(found.rebound, thornton_restitution(1 / c.speed), tolerance);

    // On the unloading branch a^2 = R_p* (delta - delta_p).
    double largest = found.largest_overlap;
    const double top = largest, low = 0.99 * top;
    const double a = law(top, radius, largest).contact_radius;
    const double b = law(low, radius, largest).contact_radius;
    const double unloading_radius = (a * a - b * b) / (top - low);
    EXPECT_NEAR(
        unloading_radius / radius, c.radius_ratio, tolerance * c.radius_ratio);
    EXPECT_NEAR(
        1 - a * a / unloading_radius / top, c.permanent_share, tolerance);
  }
}

/// Grains of R = 100 um, E = 70 GPa, nu = 0.3 with p_y = 0.5 GPa.
struct YieldingPair : testing::Test {
  double radius = 50e-6;
  ThorntonNing law =
      make_law<ThorntonNing>(ContactModel{}, GrainMaterial{70e9, 0.3, 2650});
  double yield = law.yield_overlap(radius);
  double slope = pi * law.limiting_pressure * radius;
};

TEST_F(YieldingPair, FirstYieldsWhereThorntonSays)
{
  constexpr double tolerance = 1e-3; // digits of the published values
  double largest = 0;
  const NormalAnswer<double> answer = law(yield, radius, largest);
  EXPECT_NEAR(yield, 20.85e-9, tolerance * 20.85e-9);
  EXPECT_NEAR(answer.contact_radius, 1.021e-6, tolerance * 1.021e-6);
  EXPECT_NEAR(answer.force, 1.092e-3, tolerance * 1.092e-3);
  EXPECT_NEAR(law.loading_slope(yield, radius, yield), 78.54e3, 78.54);
  const double closed = std::pow(pi, 3) * radius * radius *
                        std::pow(law.limiting_pressure, 3) /
                        (6 * std::pow(law.effective_modulus, 2));
  EXPECT_NEAR(answer.force, closed, 1e-12 * closed);
}

TEST_F(YieldingPair, IsHertzBeforeYield)
{
  const Hertz hertz{law.effective_modulus};
  for (double share : {0.0, 0.1, 0.5, 0.999}) {
    double largest = 0, same = 0;
    const auto a = law(share * yield, radius, largest);
    const auto b = hertz(share * yield, radius, same);
    const double size = law.virgin_force(yield, radius);
    EXPECT_NEAR(a.force, b.force, 1e-12 * size);
    EXPECT_NEAR(a.contact_radius, b.contact_radius, 1e-12 * radius);
    EXPECT_FALSE(law.is_plastic(radius, largest));
  }
}

TEST_F(YieldingPair, SlopeIsContinuousAtYield)
{
  const double step = 1e-5 * yield;
  const auto force = [&](double overlap) {
    double largest = 0;
    return law(overlap, radius, largest).force;
  };
  const double below = (force(yield) - force(yield - step)) / step;
  const double above = (force(yield + step) - force(yield)) / step;
  EXPECT_NEAR(below, slope, 1e-5 * slope); // Hertz curves by step / (4 yield)
  EXPECT_NEAR(above, slope, 1e-8 * slope); // straight; round-off of the step
  EXPECT_NEAR(force(5 * yield), force(yield) + 4 * slope * yield, 1e-12);
}

TEST_F(YieldingPair, ReloadingRetracesUnloading)
{
  const double top = 7 * yield;
  double largest = top;
  const auto force = [&](double overlap) {
    return law(overlap, radius, largest).force;
  };
  const double peak = force(top), low = force(0.8 * top);
  EXPECT_LT(low, peak);
  force(0);
  EXPECT_EQ(force(0.8 * top), low);
  EXPECT_EQ(force(top), peak);
  EXPECT_EQ(largest, top);
  EXPECT_NEAR(force(1.1 * top), peak + 0.1 * slope * top, 1e-12 * peak);
  EXPECT_EQ(largest, 1.1 * top);
}

TEST_F(YieldingPair, NoForceAtPermanentOverlap)
{
  const double top = 7 * yield;
  double largest = top;
  const auto [peak, a] = law(top, radius, largest);
  const double unloading_radius =
      4 * law.effective_modulus * a * a * a / (3 * peak);
  const double permanent = top - a * a / unloading_radius;
  EXPECT_GT(permanent, 0);
  EXPECT_EQ(law(0.9999 * permanent, radius, largest).force, 0);
  EXPECT_GT(law(1.0001 * permanent, radius, largest).force, 0);
}

TEST_F(YieldingPair, EnergyIsWorkOfForceAlongLoadingAndUnloading)
{
  const double top = 6 * yield;
  constexpr int parts = 20000;
  double largest = 0, work = 0;
  const auto travel = [&](double from, double to) {
    for (int k = 0; k < parts; ++k)
      work +=
          law(from + (k + 0.5) / parts * (to - from), radius, largest).force *
          (to - from) / parts;
  };
  const auto kept = [&](double overlap) {
    const NormalEnergy energy = law.energy(overlap, radius, largest);
    return energy.elastic + energy.dissipated;
  };
  travel(0, top);
  const double loading = work, tolerance = 1e-6 * loading; // midpoint rule
  largest = top; // the last midpoint lies half a part below
  EXPECT_NEAR(kept(top), loading, tolerance);
  travel(top, 0.7 * top);
  EXPECT_NEAR(kept(0.7 * top), work, tolerance);
  travel(0.7 * top, 0);
  EXPECT_NEAR(kept(0), work, tolerance);

  const double peak = law(top, radius, largest).force;
  const double yield_force = law.virgin_force(yield, radius);
  const double above = top - yield;
  const double given = 0.4 * yield_force * yield + yield_force * above +
                       0.5 * slope * above * above;
  EXPECT_NEAR(loading, given, tolerance);
  const double recovered = 0.75 * peak / law.effective_modulus /
                           std::sqrt(radius * top); // delta* - delta_p
  EXPECT_NEAR(law.energy(0, radius, top).dissipated,
              given - 0.4 * peak * recovered,
              1e-12 * given);
}

/// A sticking contact with mu = 0.4.
struct RubbingPair : testing::Test {
  Mindlin law{3e9, 0.4};
  ContactMotion now{.normal = Vector3(1, 2, -2) / 3,
                    .slip = Vector3::Zero(),
                    .radius = 1e-6,
                    .old_radius = 1e-6,
                    .force = 2e-3};
  Vector3 along = Vector3(2, 1, 2) / 3; // in the plane of the contact
  double stiffness = 8 * law.effective_shear_modulus * now.radius;
};

TEST_F(RubbingPair, SticksWithStiffnessOfMindlin)
{
  now.slip = 1e-9 * along + 3e-9 * now.normal; // approach is no slip
  const Mindlin::Answer answer = law(Vector3::Zero(), now);
  const double size = stiffness * 1e-9;
  EXPECT_LT((answer.force - size * along).norm(), 1e-12 * size);
  EXPECT_EQ(answer.slid_work, 0);
}

TEST_F(RubbingPair, CoulombsCapKeepsDirection)
{
  now.slip = 1e-7 * along;
  const Mindlin::Answer answer = law(Vector3::Zero(), now);
  const double cap = law.friction_coefficient * now.force;
  EXPECT_LT((answer.force - cap * along).norm(), 1e-12 * cap);
}

TEST_F(RubbingPair, SlidWorkIsCapTimesSlidDistance)
{
  now.slip = 1e-7 * along;
  const double cap = law.friction_coefficient * now.force;
  const double excess = stiffness * 1e-7 - cap;
  const double work = cap * excess / stiffness;
  EXPECT_NEAR(law(Vector3::Zero(), now).slid_work, work, 1e-12 * work);
}

TEST_F(RubbingPair, SteadySlidingDissipatesCapTimesSlip)
{
  const double cap = law.friction_coefficient * now.force, step = 1e-9;
  now.slip = step * along;
  const Mindlin::Answer answer = law(cap * along, now);
  EXPECT_NEAR(answer.slid_work, cap * step, 1e-9 * cap * step);
}

TEST_F(RubbingPair, ForceTurnsWithContactAndKeepsLength)
{
  const Vector3 old = 1e-4 * along;
  now.normal = (now.normal + 0.1 * along).normalized();
  const Vector3 force = law(old, now).force;
  EXPECT_NEAR(force.norm(), old.norm(), 1e-12 * old.norm());
  EXPECT_NEAR(force.dot(now.normal), 0, 1e-12 * old.norm());
  EXPECT_GT(force.dot(old), 0.99 * old.squaredNorm());
}

TEST_F(RubbingPair, ForceTurnsWithSpinOfGrains)
{
  const Vector3 old = 1e-4 * along;
  now.spin = 1e-3;
  const Vector3 wanted = old + now.spin * now.normal.cross(old);
  EXPECT_LT((law(old, now).force - wanted).norm(), 1e-12 * old.norm());
}

TEST_F(RubbingPair, ForceShrinksWithContactRadiusOnUnloadingOnly)
{
  const Vector3 old = 1e-4 * along;
  now.radius = 0.5 * now.old_radius;
  EXPECT_LT((law(old, now).force - 0.5 * old).norm(), 1e-12 * old.norm());
  now.radius = 2 * now.old_radius;
  EXPECT_LT((law(old, now).force - old).norm(), 1e-12 * old.norm());
}

TEST_F(RubbingPair, NoForceWithoutNormalForce)
{
  now.force = 0;
  now.slip = 1e-9 * along;
  const Mindlin::Answer answer = law(1e-4 * along, now);
  EXPECT_EQ(answer.force.norm(), 0);
  EXPECT_EQ(answer.slid_work, 0);
}
} // namespace
} // namespace tamp::dem
