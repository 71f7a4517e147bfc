// SPDX-License-Identifier: BSD-3-Clause
#include <dem/grain_material.h>
#include <dem/value_check.h>

namespace tamp::dem
{
void GrainMaterial::check() const
{
  const Positive positive;
  positive(youngs_modulus, "Young's modulus");
  positive(density, "density");
  if (!(poissons_ratio > -1 && poissons_ratio < 0.5))
    refuse("Poisson's ratio", poissons_ratio, "between -1 and 0.5");
}

void ContactModel::check() const
{
  if (!(friction_coefficient >= 0))
    refuse("friction coefficient", friction_coefficient, "zero or positive");
  if (normal_law == NormalLaw::thornton_ning)
    Positive{}(limiting_pressure, "limiting contact pressure");
}
} // namespace tamp::dem
