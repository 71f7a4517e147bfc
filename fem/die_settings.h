// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_die_settings_h
#define fem_die_settings_h

#include <fem/die_geometry.h>
#include <fem/friction.h>
#include <fem/linear_solver.h>

#include <array>
#include <string>
#include <vector>

namespace tamp::fem
{
enum class StageKind { press, unload, eject, hold };
enum class StageTarget {
  density,      ///< mean relative density [-]
  displacement, ///< of the moving punch, since the start of the stage [m]
  force,        ///< of the upper punch [N]
  peak_share,   ///< force of the upper punch as a share of its peak [-]
  rim           ///< eject until the compact's top reaches the die's rim
};

/// One stage of the schedule. `press` and `unload` move the upper punch;
/// `eject` moves the lower punch up while the upper one keeps `hold_share` of
/// the peak force; `hold` does `steps` steps at rest.
struct Stage {
  StageKind kind = StageKind::press;
  StageTarget target = StageTarget::density;
  double value = 0.85;
  double hold_share = 0.05;
  unsigned steps = 1;
};

/// Limits of a step, as mean axial strain of the compact [-].
struct StepLimits {
  double first = 1e-3;
  double maximum = 5e-3;
  /// Maximum while unloading and ejecting. A compact that slides as a whole
  /// goes up to 20 times as far in a step: it does not strain.
  double unloading = 1e-3;
  double minimum = 1e-6; ///< a smaller step ends the run
  double growth = 1.25;
  double cut = 0.5;
};

enum class NonlinearMethod {
  newton,  ///< a new tangent every iteration: cheap laws
  anderson ///< one tangent a step, Anderson acceleration: unit cells
};

struct SolverSettings {
  NonlinearMethod method = NonlinearMethod::anderson;
  double force_tolerance = 1e-3; ///< of the residual / reactions [-]
  /// Of the change of displacement / the increment, which counts as 5e-3 of the
  /// height at least [-].
  double displacement_tolerance = 1e-2;
  unsigned maximum_iterations = 20;
  unsigned anderson_depth = 5;
  /// Reject steps in which a point loses most of its pressure or opens while
  /// the punch presses: zero stress is an equilibrium, too.
  bool guard_against_opening = false;
  bool f_bar = false; ///< free of locking near full density, see Compact
  LinearSettings linear;
};

struct DieSettings {
  DieGeometry geometry;
  std::array<FrictionCoefficient, number_of_tools> friction{
      FrictionCoefficient(0),
      FrictionCoefficient(0),
      FrictionCoefficient(0.2),
      FrictionCoefficient(0.2)};
  std::vector<Stage> stages;
  StepLimits steps;
  SolverSettings solver;

  /// Throws std::invalid_argument naming the first value that is not
  /// possible.
  void check() const;
};
} // namespace tamp::fem

#endif
