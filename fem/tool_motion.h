// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_tool_motion_h
#define fem_tool_motion_h

#include <fem/mesh.h>

#include <array>

namespace tamp::fem
{
/// What a tool does along the pressing axis during an increment: it is moved by
/// a displacement or loaded with a force.
struct ToolMotion {
  bool loaded = false;
  double displacement = 0; ///< upwards [m]; a first guess if loaded
  /// Of the powder on the tool at the end of the increment, upwards [N], of the
  /// whole compact: positive for an upper punch that presses.
  double force = 0;
};

/// One motion per tool. The core rod goes with the die.
using Motion = std::array<ToolMotion, number_of_tools>;
} // namespace tamp::fem

#endif
