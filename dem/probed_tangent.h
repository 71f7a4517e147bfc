// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_probed_tangent_h
#define dem_probed_tangent_h

#include <dem/condensed_tangent.h>
#include <dem/deform.h>

namespace tamp::dem
{
/// How a cell is probed.
struct Probing {
  double strain = 1e-6; ///< size of a probe [-]
  /// Both ways, error of second order; or only in the direction of positive
  /// strain components.
  bool central = true;
  /// Logarithmic strain increment around which the probes lie [-]: for plastic
  /// or sliding contacts an increment of the path, much larger than `strain`.
  /// Contacts then answer as they do on this path. Zero: around the cell.
  Matrix3 path = Matrix3::Zero();
  double unbalance_tolerance = 1e-8; ///< of every relaxation [-]
  std::size_t maximum_evaluations = 50000;

  /// Throws std::invalid_argument naming the first value that is not
  /// possible.
  void check() const;
};

/// d Cauchy stress / d strain for h -> (I + strain) h by differences of
/// deform(): every probe starts from a copy of the cell, which stays as it is.
/// @return not converged if a probe did not settle
[[nodiscard]] SolvedTangent probed_tangent(const UnitCell &cell,
                                           const Probing &probing);
} // namespace tamp::dem

#endif
