// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/pair_laws.h>

#include <stdexcept>

namespace tamp::dem
{
namespace
{
// Pressure at yield over Y of a small contact.
// Source: Zunker & Kamrin (2024), 1 + 1.75 exp(0).
constexpr double small_contact = 2.75;

AnyNormalLaw normal_law(const ContactModel &model,
                        const GrainMaterial &first,
                        const PairMaterial &pair)
{
  const double modulus = pair.effective_modulus;
  const double pressure = pair.limiting_pressure;
  const double adhesion = model.work_of_adhesion;
  switch (model.normal_law) {
  case NormalLaw::hertz:
    return Hertz{modulus};
  case NormalLaw::jkr:
    return Jkr(modulus, adhesion);
  case NormalLaw::thornton_ning_jkr:
    return AdhesiveThorntonNing(modulus, pressure, adhesion);
  case NormalLaw::storakers:
    return Storakers(modulus, pressure);
  case NormalLaw::mdr:
    return Mdr(
        first.youngs_modulus, first.poissons_ratio, pressure / small_contact);
  case NormalLaw::thornton_ning_adjusted:
    return AdjustedThorntonNing(modulus, pressure);
  default:
    return ThorntonNing(modulus, pressure);
  }
}

bool sticks(NormalLaw law)
{
  return law == NormalLaw::jkr || law == NormalLaw::thornton_ning_jkr;
}

AnyTangentialLaw tangential_law(const ContactModel &model,
                                const PairMaterial &pair)
{
  const double modulus = pair.effective_shear_modulus;
  const double friction = model.friction_coefficient;
  if (model.tangential_law == TangentialLaw::none)
    return NoTangentialForce{};
  if (model.tangential_law == TangentialLaw::mindlin_deresiewicz)
    return MindlinDeresiewicz{modulus, friction};
  if (sticks(model.normal_law))
    return AdhesiveMindlin{pair.effective_modulus, modulus, friction};
  return Mindlin{modulus, friction};
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

std::size_t PairLaws::rolling_more() const
{
  return rolling ? 3 + Rolling::more : 0; // the moment comes first
}

PairLaws pair_laws(const ContactModel &model,
                   const GrainMaterial &first,
                   const GrainMaterial &second)
{
  const PairMaterial pair = pair_material(first, second);
  if (model.normal_law == NormalLaw::mdr && first != second)
    throw std::invalid_argument(
        "normal law mdr: both grains of a contact must be of one material");
  PairLaws laws{normal_law(model, first, pair),
                tangential_law(model, pair),
                {},
                {},
                pair.effective_modulus};
  if (model.rolling_law == RollingLaw::epsd)
    laws.rolling = Rolling{pair.effective_modulus,
                           pair.effective_shear_modulus,
                           model.rolling_friction_coefficient,
                           model.friction_coefficient};
  if (model.restitution_coefficient < 1)
    laws.viscous =
        Viscous(pair.effective_modulus, model.restitution_coefficient);
  return laws;
}

double spring_energy(const PairLaws &laws,
                     const PairShape<double> &pair,
                     const NormalAnswer<double> &push,
                     const Triple<double> &force,
                     const double *own)
{
  const double tangential =
      std::visit([&](const auto &law) { return law.stored(force, push, own); },
                 laws.tangential);
  if (!laws.rolling)
    return tangential;
  const double *const m = own + laws.tangential_more();
  return tangential +
         laws.rolling->stored(
             {m[0], m[1], m[2]}, {m[3], m[4], m[5]}, pair, push.contact_radius);
}

void check_adjusted(const ContactModel &model,
                    const std::vector<GrainMaterial> &materials)
{
  if (model.normal_law == NormalLaw::thornton_ning_adjusted)
    return;
  for (const GrainMaterial &material : materials)
    if (!material.adjusted_pressures.empty())
      throw std::invalid_argument(
          "the limiting contact pressure is adjusted to the density, which "
          "needs the normal law thornton-ning-adjusted: all others take it "
          "for constant");
}

void check_size(const PairLaws &laws, double reduced_radius)
{
  if (const auto *law = std::get_if<AdhesiveThorntonNing>(&laws.normal))
    law->check(reduced_radius);
}
} // namespace tamp::dem
