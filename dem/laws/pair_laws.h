// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_pair_laws_h
#define dem_laws_pair_laws_h

#include <dem/grain_material.h>
#include <dem/laws/hertz.h>
#include <dem/laws/mindlin.h>
#include <dem/laws/thornton_ning.h>

#include <cstddef>
#include <variant>

namespace tamp::dem
{
/// The list of normal laws, in the order of dem::NormalLaw. A new law is a new
/// file and an entry here.
using AnyNormalLaw = std::variant<Hertz, ThorntonNing>;

/// The list of tangential laws, in the order of dem::TangentialLaw.
using AnyTangentialLaw = std::variant<NoTangentialForce, Mindlin>;

/// The laws of pairs of two materials, with their constants.
struct PairLaws {
  AnyNormalLaw normal;
  AnyTangentialLaw tangential;
  double effective_modulus; ///< E* [Pa]

  /// Numbers that the laws keep in the memory of a contact beyond the common
  /// ones: those of the normal law, then those of the tangential one.
  std::size_t normal_more() const;
  std::size_t tangential_more() const;
};

PairLaws pair_laws(const ContactModel &model,
                   const GrainMaterial &first,
                   const GrainMaterial &second);
} // namespace tamp::dem

#endif
