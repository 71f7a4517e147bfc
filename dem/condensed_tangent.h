// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_condensed_tangent_h
#define dem_condensed_tangent_h

#include <dem/contact_network.h>
#include <dem/tangent.h>

namespace tamp::dem
{
class UnitCell;

/// A tangent that took a solution of equations.
struct SolvedTangent {
  Tangent tangent = Tangent::Zero(); ///< [Pa]
  bool converged = true;             ///< if not, the tangent is of no use
};

/// Stiffness of a cell whose grains find their balance under the strain: that
/// of voigt_stiffness() with displacements and rotations of all grains
/// condensed out, at constant geometry. What turns in `choice` turns. Without
/// sliding symmetric and never above Voigt's bound for the same contacts.
[[nodiscard]] SolvedTangent condensed_stiffness(const UnitCell &cell,
                                                const NetworkChoice &choice);

/// d Cauchy stress / d strain for h -> (I + strain) h, as voigt_tangent(), of a
/// cell whose grains find their balance: contacts turn under their normal
/// force, whatever `choice` says, branches and volume follow the strain. Left
/// out is the turning of tangential forces, of the order of mu N / (k d).
[[nodiscard]] SolvedTangent condensed_tangent(const UnitCell &cell,
                                              NetworkChoice choice);
} // namespace tamp::dem

#endif
