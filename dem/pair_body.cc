// SPDX-License-Identifier: BSD-3-Clause
#include <dem/pair_body.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace tamp::dem
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
} // namespace

Body Body::grain(double radius, const GrainMaterial &material)
{
  return {radius,
          4.0 / 3 * std::numbers::pi * material.density * radius * radius *
              radius};
}

Body Body::wall()
{
  return {infinity, infinity};
}

bool Body::is_wall() const
{
  return std::isinf(mass);
}

double Body::kinetic_energy() const
{
  if (is_wall())
    return 0;
  return 0.5 * mass * dot(velocity, velocity) +
         0.2 * mass * radius * radius * dot(spin, spin);
}

PairShape<double> shape_of(const Body &first, const Body &second)
{
  if (second.is_wall())
    return {2 * first.radius, first.radius, 0, 1 / first.mass};
  const double sum = first.radius + second.radius;
  return {sum,
          first.radius * second.radius / sum,
          second.radius - first.radius,
          1 / first.mass + 1 / second.mass};
}

GrainMaterial rigid_wall()
{
  return elastic_wall(infinity, 0);
}

GrainMaterial elastic_wall(double youngs_modulus, double poissons_ratio)
{
  return {youngs_modulus, poissons_ratio, infinity, infinity};
}
} // namespace tamp::dem
