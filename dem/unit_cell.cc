// SPDX-License-Identifier: BSD-3-Clause
#include <dem/unit_cell.h>

#include <algorithm>
#include <numbers>
#include <numeric>

namespace tamp::dem
{
double UnitCell::largest_radius() const
{
  return std::ranges::max(radius);
}

double UnitCell::smallest_radius() const
{
  return std::ranges::min(radius);
}

double UnitCell::mean_radius() const
{
  return std::accumulate(radius.begin(), radius.end(), 0.0) / double(size());
}

bool UnitCell::adjusts_pressures() const
{
  return std::ranges::any_of(materials, [](const GrainMaterial &material) {
    return !material.adjusted_pressures.empty();
  });
}

std::vector<GrainMaterial> UnitCell::materials_now() const
{
  if (!adjusts_pressures())
    return materials;
  std::vector<GrainMaterial> result;
  for (const GrainMaterial &material : materials)
    result.push_back(material.at_density(relative_density()));
  return result;
}

double UnitCell::mass(std::size_t grain) const
{
  const double r = initial_radius_of(grain);
  return 4.0 / 3 * std::numbers::pi * r * r * r * material_of(grain).density;
}

PairShape<double> UnitCell::shape(Pair pair) const
{
  const double a = radius[pair.first], b = radius[pair.second];
  return {a + b,
          a * b / (a + b),
          b - a,
          1 / mass(pair.first) + 1 / mass(pair.second)};
}

double UnitCell::solid_volume() const
{
  double sum = 0;
  for (double r : initial_radius.empty() ? radius : initial_radius)
    sum += r * r * r;
  return 4.0 / 3 * std::numbers::pi * sum;
}
} // namespace tamp::dem
