// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_law_choice_h
#define dem_laws_law_choice_h

#include <dem/grain_material.h>
#include <dem/laws/hertz.h>
#include <dem/laws/mindlin.h>
#include <dem/laws/thornton_ning.h>

namespace tamp::dem
{
/// The constants of a law, from what the user gave.
template <class Law>
Law make_law(const ContactModel &model, const GrainMaterial &material);

template <>
inline Hertz make_law(const ContactModel &, const GrainMaterial &material)
{
  return {material.effective_modulus()};
}
template <>
inline ThorntonNing make_law(const ContactModel &model,
                             const GrainMaterial &material)
{
  return {material.effective_modulus(), model.limiting_pressure};
}
template <>
inline Mindlin make_law(const ContactModel &model,
                        const GrainMaterial &material)
{
  return {material.effective_shear_modulus(), model.friction_coefficient};
}
template <>
inline NoTangentialForce make_law(const ContactModel &, const GrainMaterial &)
{
  return {};
}

/// Calls `visit` with the normal law of a model. The list of normal laws.
template <class Visitor>
auto with_normal_law(const ContactModel &model,
                     const GrainMaterial &material,
                     Visitor &&visit)
{
  if (model.normal_law == NormalLaw::hertz)
    return visit(make_law<Hertz>(model, material));
  return visit(make_law<ThorntonNing>(model, material));
}

/// Calls `visit` with the tangential law of a model. The list of tangential
/// laws.
template <class Visitor>
auto with_tangential_law(const ContactModel &model,
                         const GrainMaterial &material,
                         Visitor &&visit)
{
  if (model.tangential_law == TangentialLaw::mindlin)
    return visit(make_law<Mindlin>(model, material));
  return visit(make_law<NoTangentialForce>(model, material));
}
} // namespace tamp::dem

#endif
