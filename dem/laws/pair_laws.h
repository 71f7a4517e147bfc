// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_pair_laws_h
#define dem_laws_pair_laws_h

#include <dem/grain_material.h>
#include <dem/laws/adhesive_mindlin.h>
#include <dem/laws/adhesive_thornton_ning.h>
#include <dem/laws/adjusted_thornton_ning.h>
#include <dem/laws/hertz.h>
#include <dem/laws/jkr.h>
#include <dem/laws/mdr.h>
#include <dem/laws/mindlin.h>
#include <dem/laws/mindlin_deresiewicz.h>
#include <dem/laws/rolling.h>
#include <dem/laws/storakers.h>
#include <dem/laws/thornton_ning.h>
#include <dem/laws/viscous.h>

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace tamp::dem
{
/// The list of normal laws, in the order of dem::NormalLaw. A new law is a new
/// file and an entry here.
using AnyNormalLaw = std::variant<Hertz,
                                  ThorntonNing,
                                  Jkr,
                                  AdhesiveThorntonNing,
                                  Storakers,
                                  Mdr,
                                  AdjustedThorntonNing>;

/// The list of tangential laws.
using AnyTangentialLaw = std::
    variant<NoTangentialForce, Mindlin, MindlinDeresiewicz, AdhesiveMindlin>;

/// The laws of pairs of two materials, with their constants.
struct PairLaws {
  AnyNormalLaw normal;
  AnyTangentialLaw tangential;
  std::optional<Rolling> rolling;
  std::optional<Viscous> viscous; ///< acts in dynamics only
  double effective_modulus;       ///< E* [Pa]

  // Numbers that the laws keep in the memory of a contact beyond the common
  // ones, in this order.
  std::size_t normal_more() const;
  std::size_t tangential_more() const;
  std::size_t rolling_more() const;
  std::size_t more() const
  {
    return normal_more() + tangential_more() + rolling_more();
  }
};

/// Under a normal law with adhesion, mindlin is AdhesiveMindlin. Mdr's yield
/// stress Y is p_y / 2.75, p_y being the pressure at which its contacts yield
/// when they are small. Both grains have the first material there: throws
/// std::invalid_argument if the second is another.
PairLaws pair_laws(const ContactModel &model,
                   const GrainMaterial &first,
                   const GrainMaterial &second);
/// What the tangential and the rolling spring of a contact hold [J].
/// @param push   without damping
/// @param force  tangential, on the first grain, without damping [N]
/// @param own    numbers that the tangential and the rolling law keep
double spring_energy(const PairLaws &laws,
                     const PairShape<double> &pair,
                     const NormalAnswer<double> &push,
                     const Triple<double> &force,
                     const double *own);

/// Throws std::invalid_argument if a limiting contact pressure is adjusted to
/// the density under a law that takes it for constant.
void check_adjusted(const ContactModel &model,
                    const std::vector<GrainMaterial> &materials);

/// Throws std::invalid_argument if the laws do not hold for grains so small:
/// see AdhesiveThorntonNing::check().
void check_size(const PairLaws &laws, double reduced_radius);
} // namespace tamp::dem

#endif
