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
  displacement, ///< of each moving tool, since the start of the stage [m]
  force,        ///< of the punch that presses; of the upper one if both do [N]
  peak_share,   ///< the same force as a share of its peak [-]
  nothing,      ///< unload until the punch has left the compact
  rim,          ///< eject until the compact's upper edge is at the die's rim
  out           ///< eject until the lower punch's edge is at the die's rim
};
/// Who presses. `both` move towards each other by equal lengths.
enum class Pressing { upper, lower, both };
enum class Ejection {
  push,      ///< the lower punch pushes the compact up
  withdrawal ///< the die is drawn down over the compact, the lower punch rests
};

/// One stage of the schedule. `press` moves a punch or both; `unload` retracts
/// the one that pressed last, the upper one if both did: the lower one stays,
/// as in a press. `eject` pushes the compact out of the die, or draws the die
/// off it, while the upper punch keeps `hold_share` of the peak force; zero
/// sets the compact free: the upper punch leaves it first, and then goes ahead
/// of it. `hold` does `steps` steps at rest. Unloading to a force of zero is
/// unloading to nothing.
struct Stage {
  StageKind kind = StageKind::press;
  StageTarget target = StageTarget::density;
  double value = 0.85;
  double hold_share = 0.05;
  unsigned steps = 1;
  Pressing pressing = Pressing::upper; ///< of `press`
  Ejection ejection = Ejection::push;  ///< of `eject`

  /// Does an unloading end, or an ejection begin, without contact of the punch?
  bool frees() const;
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
  /// Maximum while the compact passes the die's rim, where its nodes leave the
  /// wall one by one: as a share of the height of an element at the wall [-].
  double rim = 0.25;
};

enum class NonlinearMethod {
  newton,  ///< a new tangent every iteration: cheap laws
  anderson ///< one tangent a step, Anderson acceleration: unit cells
};

struct SolverSettings {
  NonlinearMethod method = NonlinearMethod::anderson;
  double force_tolerance = 1e-3; ///< of the residual / reactions [-]
  /// Reactions count as at least this share of their peak: at zero force there
  /// is nothing else to compare with [-].
  double least_reaction = 1e-4;
  /// Of the change of displacement / the increment, which counts as 5e-3 of the
  /// height at least [-].
  double displacement_tolerance = 1e-2;
  unsigned maximum_iterations = 20;
  unsigned anderson_depth = 5;
  /// Reject steps in which a point opens, see find_opening(): zero stress is an
  /// equilibrium, too.
  bool guard_against_opening = false;
  bool f_bar = false; ///< free of locking near full density, see Compact
  /// The tools are balanced by repeated solutions, each of what is left over:
  /// an iterative one need not be sharp, and the balance is all the same.
  LinearSettings linear{.tolerance = 1e-3};
};

struct DieSettings {
  DieGeometry geometry;
  std::array<FrictionCoefficient, number_of_tools> friction{
      FrictionCoefficient(0),
      FrictionCoefficient(0),
      FrictionCoefficient(0.2),
      FrictionCoefficient(0.2)};
  /// The die is carried by friction alone until the compact is ejected.
  bool floating_die = false;
  std::vector<Stage> stages;
  StepLimits steps;
  SolverSettings solver;

  /// Throws std::invalid_argument naming the first value that is not
  /// possible, alone or with those before it.
  void check() const;

  /// Throws std::invalid_argument if the stages bring the punches closer than
  /// powder of this height lets them [m]. check() does so for the dies that are
  /// built in; a mesh has a height of its own.
  void check_way(double height) const;

  /// Throws std::invalid_argument if powder of this mean relative density is
  /// as dense as the first pressing wants it, or denser.
  void check_start(double density) const;
};
} // namespace tamp::fem

#endif
