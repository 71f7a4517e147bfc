// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_path_driver_h
#define fem_path_driver_h

#include <fem/material_points.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace tamp::fem
{
/// What one component (xx, yy, zz, yz, xz, xy) does during a stage of a path.
struct ComponentTarget {
  enum class Control { strain, stress } control = Control::strain;
  /// At the end of the stage: logarithmic strain since the start of the path
  /// (compression negative) [-], or Cauchy stress (tension positive) [Pa].
  double value = 0;
  /// Strain control only: the value is a change since the start of the stage.
  bool relative = false;
};

/// A part of a path, driven in equal increments of at most `maximum_increment`
/// strain (of at most 1.5 times that where the strain follows from stress).
/// Symmetric stretches; components under stress control are found by
/// iteration. Shear components are those of the tensors: half the engineering
/// shear. An increment that does not converge is halved, at most 8 times.
struct PathStage {
  std::string name;
  std::array<ComponentTarget, 6> components;
  double maximum_increment = 1e-3; ///< strain of the largest component [-]
  unsigned minimum_steps = 1;
  /// Ends the stage early once the stress of component `until_component`
  /// (tension positive) rises above (until_above) or falls below this value;
  /// the last increment is refined to hit it within 1 % (of the largest stress
  /// at the start of the stage, if this value is zero). A stage whose condition
  /// holds at its start takes no increment.
  bool has_until = false;
  unsigned until_component = 2;
  double until_stress = 0;
  bool until_above = true;
  /// If there are any, the stage follows these instead of its components: F
  /// since its start, an increment each. Rotation and all.
  std::vector<dealii::Tensor<2, 3>> gradients;
  /// If there are any, the stage follows these: F of each increment since the
  /// one before, to the last bit. One that fails ends the path.
  std::vector<dealii::Tensor<2, 3>> increments;
  /// What the components under stress control aim at is their stress plus this
  /// times that of zz: with 1/2, and 3/2 of a mean stress as the value of xx
  /// and yy, the mean stress is held while zz is strained [-].
  double axial_share = 0;
  /// What is prescribed of zz is its strain less the mean of those of xx and
  /// yy, which must be under stress control: a powder that dilates and softens
  /// may not follow its axial strain alone.
  bool deviatoric = false;
  /// Ends the stage early once it says so after an increment; may be empty.
  std::function<bool()> enough;
};

/// State of the one point after an accepted increment.
struct PathRecord {
  unsigned step = 0;
  unsigned stage = 0;
  dealii::Tensor<2, 3> F; ///< since the start
  Response response;
};

enum class PathEnd {
  finished,
  not_converged,
  not_reached ///< a stage came to its end without meeting its stress
};

/// Takes point 0 of `points` along stages; calls `observe` after the start
/// state (step 0) and after each committed increment. `stage_begins` is called
/// before each stage with its index. Stress control converges to
/// `stress_tolerance` times the largest stress: of the trial, of the start and
/// of the targets of the stage. Strains count from the state that the point has
/// at the call, as ln V of F = V R; components keep the rotation R that
/// gradients have led to; a point that is doubtful is taken as it is. Either
/// function may be empty. After `not_converged` the point is in the last
/// observed state.
[[nodiscard]] PathEnd
drive_path(MaterialPoints &points,
           const std::vector<PathStage> &stages,
           const std::function<void(unsigned)> &stage_begins,
           const std::function<void(const PathRecord &)> &observe,
           double stress_tolerance = 1e-3);

/// A path of one stage of given increments F_new F_old^-1, one commit each:
/// what a die told one of its points is replayed to the last bit.
[[nodiscard]] PathEnd
drive_increments(MaterialPoints &points,
                 const std::vector<dealii::Tensor<2, 3>> &increments,
                 const std::function<void(const PathRecord &)> &observe);
} // namespace tamp::fem

#endif
