// SPDX-License-Identifier: BSD-3-Clause
#include <dem/grain_material.h>
#include <dem/value_check.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tamp::dem
{
void GrainMaterial::check() const
{
  const Positive positive;
  positive(youngs_modulus, "Young's modulus");
  positive(density, "density");
  positive(limiting_pressure, "limiting contact pressure");
  double density_before = 0;
  for (const PressureAtDensity &node : adjusted_pressures) {
    positive(node.limiting_pressure, "adjusted limiting contact pressure");
    if (!(node.relative_density > density_before &&
          std::isfinite(node.relative_density)))
      refuse("relative density of an adjusted limiting contact pressure",
             node.relative_density,
             "positive ones that rise");
    density_before = node.relative_density;
  }
  if (!(poissons_ratio > -1 && poissons_ratio < 0.5))
    refuse("Poisson's ratio", poissons_ratio, "between -1 and 0.5");
}

GrainMaterial GrainMaterial::at_density(double relative_density) const
{
  if (adjusted_pressures.empty())
    return *this;
  GrainMaterial material = *this;
  material.adjusted_pressures.clear();
  const auto above =
      std::ranges::upper_bound(adjusted_pressures,
                               relative_density,
                               {},
                               &PressureAtDensity::relative_density);
  if (above == adjusted_pressures.begin()) {
    material.limiting_pressure = above->limiting_pressure;
    return material;
  }
  const auto &[density, pressure] = *std::prev(above);
  material.limiting_pressure = pressure;
  if (above != adjusted_pressures.end())
    material.limiting_pressure *= std::pow(
        above->limiting_pressure / pressure,
        (relative_density - density) / (above->relative_density - density));
  return material;
}

PairMaterial pair_material(const GrainMaterial &first,
                           const GrainMaterial &second)
{
  const auto compliance = [](const GrainMaterial &m) {
    return (1 - m.poissons_ratio * m.poissons_ratio) / m.youngs_modulus;
  };
  const auto shear_compliance = [](const GrainMaterial &m) {
    return (2 - m.poissons_ratio) / m.shear_modulus();
  };
  return {1 / (compliance(first) + compliance(second)),
          1 / (shear_compliance(first) + shear_compliance(second)),
          std::min(first.limiting_pressure, second.limiting_pressure)};
}

bool ContactModel::adheres() const
{
  return work_of_adhesion > 0 && (normal_law == NormalLaw::jkr ||
                                  normal_law == NormalLaw::thornton_ning_jkr);
}

void ContactModel::check() const
{
  const auto not_negative = [](double value, const char *name) {
    if (!(value >= 0))
      refuse(name, value, "zero or positive");
  };
  not_negative(friction_coefficient, "friction coefficient");
  not_negative(work_of_adhesion, "work of adhesion");
  not_negative(rolling_friction_coefficient, "rolling friction coefficient");
  if (!(restitution_coefficient > 0 && restitution_coefficient <= 1))
    refuse("restitution coefficient",
           restitution_coefficient,
           "above 0 and at most 1");
  if (!(bulk_onset >= 0 && bulk_onset < 1))
    refuse("bulk onset", bulk_onset, "at least 0 and below 1");
}
} // namespace tamp::dem
