// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_pair_throw_h
#define tests_dem_pair_throw_h

#include <dem/pair_impact.h>

#include <array>
#include <numbers>

namespace tamp::dem::test
{
constexpr double pi = std::numbers::pi;

/// What a sphere hits: a plane of some stiffness, a grain of the same size that
/// comes as fast, or one at rest that is five times as large and, by its
/// density, does not move.
enum class Against {
  rigid_wall,
  stiff_wall, ///< 1000 times the modulus of the sphere
  equal_wall, ///< the modulus of the sphere
  equal_grain,
  large_grain
};

/// A sphere thrown in a plane. With the spin positive about y, its patch moves
/// along x with v_t + R spin. An equal grain has the opposite velocity and the
/// same spin, so that each of the two moves like a sphere on a plane.
struct Throw {
  GrainMaterial solid;
  double radius;
  ContactModel model;
  double normal, tangential = 0, spin = 0;
  Against against = Against::rigid_wall;
  double steps = Impact::default_steps;
};

/// What comes out, seen as a sphere on a plane; normal is positive outwards.
struct Thrown : Rebound {
  double normal, tangential, spin, patch;
  PairLosses losses;
};

inline ContactModel hertz_mindlin(double restitution, double friction)
{
  ContactModel model;
  model.normal_law = NormalLaw::hertz;
  model.restitution_coefficient = restitution;
  model.friction_coefficient = friction;
  return model;
}

struct Pair {
  PairContact contact;
  std::array<Body, 2> bodies;
};

inline Pair pair_of(const Throw &c)
{
  GrainMaterial other = c.solid;
  Body first = Body::grain(c.radius, c.solid), second = Body::wall();
  first.velocity = {c.tangential, 0, c.normal};
  first.spin = {0, c.spin, 0};
  switch (c.against) {
  case Against::rigid_wall:
    other = rigid_wall();
    break;
  case Against::stiff_wall:
    other = elastic_wall(1000 * c.solid.youngs_modulus, c.solid.poissons_ratio);
    break;
  case Against::equal_wall:
    other = elastic_wall(c.solid.youngs_modulus, c.solid.poissons_ratio);
    break;
  case Against::equal_grain:
    second = first;
    second.velocity = -1.0 * first.velocity;
    break;
  case Against::large_grain:
    other.density *= 1e6;
    second = Body::grain(5 * c.radius, other);
    break;
  }
  return {{pair_laws(c.model, c.solid, other), shape_of(first, second)},
          {first, second}};
}

inline Thrown thrown(const Throw &c)
{
  const Pair pair = pair_of(c);
  Impact impact(pair.contact, pair.bodies, c.steps);
  while (impact.step()) {
  }
  const Rebound end = impact.rebound();
  const double share = c.against == Against::equal_grain ? 0.5 : 1;
  return {end,
          -share * end.normal_velocity,
          share * end.tangential_velocity.x,
          impact.bodies()[0].spin.y,
          share * end.patch_velocity.x,
          impact.contact().losses()};
}
} // namespace tamp::dem::test

#endif
