// SPDX-License-Identifier: BSD-3-Clause
#include <dem/dynamics.h>
#include <dem/growing_motion.h>
#include <dem/stretch.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tamp::dem
{
namespace
{
// Grains under a larger mean force, over the contact force, are not near static
// equilibrium.
constexpr double largest_unbalance = 1e-2;
// Strain after which the time step is chosen anew.
constexpr double strain_of_a_part = 1e-3;
} // namespace

CellAnswer deform_by_dynamics(UnitCell &cell,
                              const Stretch &stretch,
                              const Dynamics &settings,
                              const Arithmetic &arithmetic)
{
  const Matrix3 log_stretch = logarithm(stretch), h = stretch * cell.box.h;
  const double size = largest_principal(log_stretch);
  const double parts = std::max(1.0, std::ceil(size / strain_of_a_part - 1e-9));
  const auto motion = start_growing_motion(cell, settings, arithmetic);
  for (int part = 0; part < int(parts); ++part) {
    const double step = motion->time_step();
    const double steps =
        std::ceil(size / parts / (settings.strain_rate * step) - 1e-9);
    if (!motion->advance(
            log_stretch / parts, std::size_t(std::max(1.0, steps)), step))
      return end_motion(*motion, Outcome::diverged);
  }
  cell.box.h = h; // the product of the parts, without their round-off
  CellAnswer answer = end_motion(*motion, Outcome::settled);
  if (answer.unbalance > largest_unbalance)
    answer.outcome = Outcome::unsettled;
  return answer;
}

DynamicMeasures measure_dynamics(const UnitCell &cell,
                                 const Dynamics &settings,
                                 double pressure)
{
  DynamicMeasures result;
  double mass = 0;
  double limiting_pressure = std::numeric_limits<double>::infinity();
  const std::vector<GrainMaterial> materials = cell.materials_now();
  for (std::size_t i = 0; i < cell.size(); ++i) {
    mass += cell.mass(i);
    limiting_pressure =
        std::min(limiting_pressure,
                 materials[cell.species.empty() ? 0 : cell.species[i]]
                     .limiting_pressure);
  }
  const double density = settings.density_scaling * mass / cell.solid_volume();
  if (pressure > 0)
    result.inertial_number = settings.strain_rate * 2 * cell.mean_radius() *
                             std::sqrt(density / pressure);
  result.scaling_number = settings.strain_rate * cell.smallest_radius() *
                          std::sqrt(density / limiting_pressure);
  for (std::size_t i = 0; i < cell.velocity.size(); ++i)
    result.kinetic_energy +=
        0.5 * settings.density_scaling * cell.mass(i) *
        (cell.velocity[i].squaredNorm() +
         0.4 * cell.radius[i] * cell.radius[i] * cell.spin[i].squaredNorm());
  return result;
}
} // namespace tamp::dem
