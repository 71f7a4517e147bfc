// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_yield_branch_h
#define fem_yield_branch_h

#include <fem/yield_search.h>

#include <functional>
#include <string>
#include <vector>

namespace tamp::fem
{
/// How a point is loaded again after it was unloaded to an isotropic stress.
enum class BranchKind {
  compression, ///< sheared by axial compression at constant pressure
  extension,   ///< sheared by axial extension at constant pressure
  triaxial,    ///< compressed along the axis at constant lateral stress
  isotropic,   ///< compressed alike in all directions
  uniaxial     ///< compressed along the axis, lateral strains held
};

/// "sheared by axial compression at constant pressure", and so on.
std::string words_of(BranchKind kind);

/// How branches are driven.
struct BranchDriving {
  double increment = 2e-4;        ///< of strain until yield [-]
  double coarse_increment = 1e-3; ///< of strain from there to the peak [-]
  /// Axial, or axial less lateral if sheared: until yield, and from there [-]
  double largest_strain = 0.2;
  double stress_tolerance = 1e-3; ///< see drive_path()
  std::function<void()> turn; ///< called where the direction turns, or empty
};

/// Unloads point 0 to an isotropic stress, in ten steps or more.
/// @param pressure  compression positive [Pa]
[[nodiscard]] PathEnd unload_to(MaterialPoints &points,
                                double pressure,
                                const BranchDriving &driving);

/// What a branch found.
struct BranchEnd {
  std::vector<YieldPoint> points;
  PathEnd end = PathEnd::finished;
};

/// Loads point 0, which is under an isotropic stress, until it has yielded; if
/// it is sheared, further to a peak or the critical state, see
/// YieldSearch::ended().
BranchEnd drive_branch(MaterialPoints &points,
                       BranchKind kind,
                       const YieldLimits &limits,
                       const ModuliOverPressure &moduli,
                       const BranchDriving &driving);
} // namespace tamp::fem

#endif
