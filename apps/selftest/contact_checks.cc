// SPDX-License-Identifier: BSD-3-Clause
#include <apps/selftest/self_checks.h>
#include <dem/pair_impact.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace tamp::apps
{
namespace
{
using namespace dem;
using Checks = std::vector<SelfCheck>;
constexpr double pi = std::numbers::pi;

/// Two equal grains that come head on, each with this speed.
Rebound collide(const ContactModel &model,
                const GrainMaterial &solid,
                double radius,
                double speed)
{
  Body first = Body::grain(radius, solid), second = first;
  first.velocity = {0, 0, speed};
  second.velocity = {0, 0, -speed};
  Impact impact({pair_laws(model, solid, solid), shape_of(first, second)},
                {first, second});
  while (impact.step()) {
  }
  return impact.rebound();
}

void elastic_impacts(Checks &checks)
{
  // Chung and Ooi give curves; numbers by Hertz (1882), to the digits shown.
  constexpr double digits = 1e-3;
  const std::string source = "Hertz; Chung & Ooi (2011), test 1";
  const auto glass =
      collide({.normal_law = NormalLaw::hertz}, {48e9, .2, 2800}, .01, 10);
  checks.push_back({"impact of glass spheres: largest force [N]",
                    glass.largest_force,
                    10697,
                    digits,
                    source});
  checks.push_back({"  largest overlap [m]",
                    glass.largest_overlap,
                    274.11e-6,
                    digits,
                    source});
  checks.push_back(
      {"  time of contact [s]", glass.duration, 40.34e-6, digits, source});
}

/// A sphere that slides on a rigid wall throughout the impact.
void sliding_impact(Checks &checks)
{
  constexpr double digits = 1e-3; // of the steps with damping, see Impact
  constexpr double speed = 3.9, angle = 40 * pi / 180, mu = .092, e = .98;
  const GrainMaterial solid{380e9, .23, 4000};
  Body sphere = Body::grain(2.5e-3, solid);
  const double along = speed * std::sin(angle);
  sphere.velocity = {along, 0, speed * std::cos(angle)};
  const ContactModel model{.normal_law = NormalLaw::hertz,
                           .friction_coefficient = mu,
                           .restitution_coefficient = e};
  Impact impact(
      {pair_laws(model, solid, rigid_wall()), shape_of(sphere, Body::wall())},
      {sphere, Body::wall()});
  while (impact.step()) {
  }
  const std::string source = "Chung & Ooi (2011), test 4";
  checks.push_back({"oblique impact on a wall: tangential restitution",
                    impact.rebound().tangential_velocity.x / along,
                    1 - mu * (1 + e) / std::tan(angle),
                    digits,
                    source});
  checks.push_back(
      {"  spin [rad/s]", impact.bodies()[0].spin.y, -544.3, digits, source});
}

void yielding_impacts(Checks &checks)
{
  constexpr double digits = 1e-3; // of the steps, see Impact
  const GrainMaterial solid{70e9, .3, 2650, .5e9};
  const double radius = 100e-6, reduced = radius / 2;
  const double mass = Body::grain(radius, solid).mass / 2;
  const double modulus = pair_material(solid, solid).effective_modulus;
  const double yield = std::pow(pi / (2 * modulus), 2) *
                       std::sqrt(8 * pi * std::pow(reduced, 3) / (15 * mass)) *
                       std::pow(solid.limiting_pressure, 2.5);
  for (const auto &[speed, restitution] :
       {std::pair{2., .930626}, {5., .773337}, {20., .557109}}) {
    const auto end = collide({}, solid, radius, speed * yield / 2);
    checks.push_back({fmt::format("restitution at {:g} yield speeds", speed),
                      -end.normal_velocity / (speed * yield),
                      restitution,
                      digits,
                      "Thornton (1997)"});
  }
  const PairShape<double> pair{2 * radius, reduced, 0, 1 / mass};
  const ThorntonNing law(modulus, solid.limiting_pressure);
  NormalMemory<double> memory{0, 0};
  const double overlap = law.yield_overlap(pair);
  checks.push_back({"first yield: overlap [m]",
                    overlap,
                    20.85e-9,
                    digits,
                    "Thornton & Ning (1998)"});
  checks.push_back({"  force [N]",
                    law(overlap, pair, memory).force,
                    1.092e-3,
                    digits,
                    "Thornton & Ning (1998)"});
}

void adhesion(Checks &checks)
{
  constexpr double digits = 1e-5, modulus = 1e11, energy = .2, radius = 1e-6;
  const std::string source = "Johnson, Kendall & Roberts (1971)";
  const Jkr law(modulus, energy);
  const PairShape<double> pair{4 * radius, radius, 0, 0};
  const double unit = law.pull_off(radius);
  const double tear =
      -.75 * std::cbrt(std::pow(pi * energy / modulus, 2) * radius);
  const auto force = [&](double overlap) {
    NormalMemory<double> touching{0, radius};
    return law(overlap, pair, touching).force / unit;
  };
  double least = 0;
  constexpr int parts = 2000;
  for (int k = 1; k < parts; ++k)
    least = std::min(least, force(tear * k / parts));
  checks.push_back({"adhesion: force at touch / (3/2 pi Gamma R*)",
                    force(0),
                    -8. / 9,
                    digits,
                    source});
  checks.push_back({"  at pull-off", least, -1, digits, source});
  checks.push_back(
      {"  at tear-off", force(tear * (1 - 1e-13)), -5. / 9, digits, source});
}

void adhesion_with_yield(Checks &checks)
{
  constexpr double digits = 1e-4; // as below
  const std::string source = "Thornton & Ning (1998)";
  const PairShape<double> pair{4, 1, 0, 0};
  const Jkr elastic(1, 1e-3);
  const AdhesiveThorntonNing law(1, .3, 1e-3);
  const double yield =
      std::pow(AdhesiveYield(1, .3, elastic).dent(0., pair).yield_root, 2);
  checks.push_back({"adhesive yield at E* = R* = 1: contact radius [m]",
                    yield,
                    .5259,
                    digits,
                    source});
  NormalMemory<double> memory{0, 0};
  const auto pressed =
      law(elastic.overlap(std::sqrt(2 * yield), 1.), pair, memory);
  const double unit = elastic.pull_off(1.);
  checks.push_back({"  force at twice that radius / (3/2 pi Gamma R*)",
                    pressed.force / unit,
                    188.945,
                    digits,
                    source});
  checks.push_back({"  pull-off after that",
                    pressed.pull_off / unit,
                    1.46165,
                    digits,
                    source});
}

void friction_loop(Checks &checks)
{
  constexpr double digits = 1e-5; // as below
  const std::string source =
      "Mindlin & Deresiewicz (1953); Johnson (1985) 7.59";
  const GrainMaterial solid;
  const ContactModel model{.normal_law = NormalLaw::hertz,
                           .tangential_law = TangentialLaw::mindlin_deresiewicz,
                           .friction_coefficient = .4};
  const Body grain = Body::grain(1e-4, solid);
  PairContact contact(pair_laws(model, solid, solid), shape_of(grain, grain));
  constexpr double overlap = 1e-7;
  contact.advance({.overlap = overlap, .slip = {0, 0, -overlap}});
  const double limit = model.friction_coefficient * contact.forces().push.force;
  const double shear = pair_material(solid, solid).effective_shear_modulus;
  const double way = .8 * 3 * limit / (16 * shear * contact.contact_radius());
  const auto slip = [&](double length) {
    for (int k = 0; k < 10; ++k)
      contact.advance({.overlap = overlap, .slip = {length / 10, 0, 0}});
  };
  slip(way);
  checks.push_back({"friction loop: largest force / (mu N)",
                    std::abs(contact.forces().rub.x) / limit,
                    .910557,
                    digits,
                    source});
  slip(-2 * way);
  const double before = contact.losses().friction;
  slip(2 * way);
  slip(-2 * way);
  checks.push_back({"  loss / (mu^2 N^2 / (G* a))",
                    (contact.losses().friction - before) * shear *
                        contact.contact_radius() / (limit * limit),
                    .0643988,
                    digits,
                    source});
}

void high_density(Checks &checks)
{
  constexpr double digits = 1e-3, radius = .5, yield = 50e6; // as below
  const std::string source = "Zunker & Kamrin (2024)";
  const SphereOnFlat flat(1e9, .3, yield);
  checks.push_back({"grain on a flat (mdr): yield overlap / R",
                    flat.yield_ratio(),
                    .06239,
                    digits,
                    source});
  for (const auto &[ratio, force, plastic] :
       {std::array{.1, .8787, .5099}, {.2, 1.6347, .7661}}) {
    const auto peak = flat.peak(ratio * radius, radius);
    checks.push_back({fmt::format("  force at {:g} R / (R^2 Y)", ratio),
                      peak.force / (radius * radius * yield),
                      force,
                      digits,
                      source});
    checks.push_back({"    permanent share of the overlap",
                      1 - peak.recovery / peak.overlap,
                      plastic,
                      digits,
                      source});
  }
}
} // namespace

std::vector<SelfCheck> check_contacts()
{
  Checks checks;
  elastic_impacts(checks);
  sliding_impact(checks);
  yielding_impacts(checks);
  adhesion(checks);
  adhesion_with_yield(checks);
  friction_loop(checks);
  high_density(checks);
  return checks;
}
} // namespace tamp::apps
