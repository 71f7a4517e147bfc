// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_press_state_h
#define fem_press_state_h

#include <fem/mesh.h>

#include <array>

namespace tamp::fem
{
/// Forces of the powder on the tools, upwards, of the whole compact [N].
using ForceOnTools = std::array<double, number_of_tools>;

/// What the schedule looks at after an accepted step.
struct PressState {
  double height = 0;      ///< from edge to edge of the punches [m]
  double fill_height = 0; ///< the height at the start [m]
  /// z of the compact's upper edge [m]: of the upper punch's edge as long as
  /// the punch touches.
  double top = 0;
  double bottom = 0;             ///< z of the lower punch's edge [m]
  double rim = 0;                ///< z of the die's rim, where it is now [m]
  double upper_displacement = 0; ///< downwards, since the start [m]
  double lower_displacement = 0; ///< upwards, since the start [m]
  double die_displacement = 0;   ///< upwards, since the start [m]
  ForceOnTools force{};          ///< [N]
  double peak_force = 0;         ///< largest Schedule::pressing_force [N]
  double mean_density = 0;       ///< relative [-]
  double element_height = 0; ///< mean height of the elements at the wall [m]
  /// How far above the rim the compact must stand to be free of the die [m].
  double fading_height = 0;
};
} // namespace tamp::fem

#endif
