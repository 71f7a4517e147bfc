// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_laws_impact_h
#define tests_dem_laws_impact_h

#include <dem/laws/pair_law.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tamp::dem::test
{
/// A pair of equal grains with a reduced radius R* [m]; 1/m* [1/kg] only where
/// it matters.
inline PairShape<double> equal_pair(double reduced_radius,
                                    double inverse_mass = 0)
{
  return {4 * reduced_radius, reduced_radius, 0, inverse_mass};
}

/// What a head-on impact of two grains comes to.
struct Impact {
  double largest_force = 0, largest_overlap = 0, duration = 0, rebound = 0;
};

/// Integrates m* delta'' = -N by velocity Verlet, with a step that follows the
/// stiffness of the contact.
/// @param effective_modulus  E* [Pa], for the length of the first step
/// @param speed              of approach [m/s]
template <class Law>
Impact collide(const Law &law,
               const PairShape<double> &pair,
               double effective_modulus,
               double speed)
{
  constexpr double step_share = 2e-3; // of 1 / frequency; errors go with the
                                      // square of it
  const double mass = 1 / pair.inverse_mass;
  // Enough overlap for a first step length: a thousandth of the elastic one.
  const double small =
      1e-3 * std::pow(mass * speed * speed /
                          (effective_modulus * std::sqrt(pair.reduced_radius)),
                      0.4);
  std::array<double, Law::more + 1> more = {};
  NormalMemory<double> memory = {0, 0, more.data()};
  const auto frequency = [&] {
    NormalMemory<double> touching = memory;
    touching.largest_overlap = std::max(memory.largest_overlap, small);
    return std::sqrt(law.steepest_slope(pair, touching) / mass);
  };
  Impact impact;
  double overlap = 0, velocity = speed, force = 0;
  while (overlap > 0 || velocity > 0) {
    const double step = step_share / frequency();
    velocity -= 0.5 * step * force / mass;
    overlap += step * velocity;
    const NormalAnswer<double> answer = law(overlap, pair, memory);
    force = answer.force;
    memory.contact_radius = answer.contact_radius;
    velocity -= 0.5 * step * force / mass;
    impact.duration += step;
    impact.largest_force = std::max(impact.largest_force, force);
    if (velocity < 0 && answer.contact_radius == 0)
      break;
  }
  impact.largest_overlap = memory.largest_overlap;
  impact.rebound = -velocity / speed;
  return impact;
}
} // namespace tamp::dem::test

#endif
