// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/pair_laws.h>

namespace tamp::dem
{
namespace
{
AnyNormalLaw normal_law(NormalLaw law, const PairMaterial &material)
{
  switch (law) {
  case NormalLaw::hertz:
    return Hertz{material.effective_modulus};
  default:
    return ThorntonNing(material.effective_modulus, material.limiting_pressure);
  }
}

AnyTangentialLaw tangential_law(const ContactModel &model,
                                const PairMaterial &material)
{
  switch (model.tangential_law) {
  case TangentialLaw::none:
    return NoTangentialForce{};
  default:
    return Mindlin{material.effective_shear_modulus,
                   model.friction_coefficient};
  }
}

std::size_t more_of(const auto &law)
{
  return std::visit([](const auto &l) { return std::size_t(l.more); }, law);
}
} // namespace

std::size_t PairLaws::normal_more() const
{
  return more_of(normal);
}

std::size_t PairLaws::tangential_more() const
{
  return more_of(tangential);
}

PairLaws pair_laws(const ContactModel &model,
                   const GrainMaterial &first,
                   const GrainMaterial &second)
{
  const PairMaterial material = pair_material(first, second);
  return {normal_law(model.normal_law, material),
          tangential_law(model, material),
          material.effective_modulus};
}
} // namespace tamp::dem
