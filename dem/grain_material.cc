// SPDX-License-Identifier: BSD-3-Clause
#include <dem/grain_material.h>
#include <dem/value_check.h>

#include <algorithm>

namespace tamp::dem
{
void GrainMaterial::check() const
{
  const Positive positive;
  positive(youngs_modulus, "Young's modulus");
  positive(density, "density");
  positive(limiting_pressure, "limiting contact pressure");
  if (!(poissons_ratio > -1 && poissons_ratio < 0.5))
    refuse("Poisson's ratio", poissons_ratio, "between -1 and 0.5");
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
