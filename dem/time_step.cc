// SPDX-License-Identifier: BSD-3-Clause
#include <dem/time_step.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace tamp::dem
{
double rayleigh_time_step(const GrainMaterial &material,
                          double smallest_radius,
                          double density_scaling)
{
  const double alpha = 0.1631 * material.poissons_ratio + 0.876605;
  return std::numbers::pi * smallest_radius / alpha *
         std::sqrt(density_scaling * material.density /
                   material.shear_modulus());
}

double stable_time_step(double frequency, double damping_ratio)
{
  // sqrt(1 + zeta^2) - zeta without cancellation
  return frequency > 0
             ? 2 / frequency / (std::hypot(1, damping_ratio) + damping_ratio)
             : std::numeric_limits<double>::infinity();
}
} // namespace tamp::dem
