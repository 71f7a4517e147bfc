// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_servo_h
#define dem_servo_h

#include <dem/compression.h>
#include <dem/deform.h>

#include <cstddef>

namespace tamp::dem
{
class UnitCell;

/// When a servo-controlled cell counts as having reached its pressure.
struct ServoGoal {
  double pressure = 100e3;          ///< p_d, isotropic [Pa]
  double accuracy = 1e-2;           ///< |p - p_d| / p_d [-]
  double unbalance = 5e-3;          ///< mean |F| of grains / mean |f| [-]
  std::size_t most_steps = 2000000; ///< time steps before it gives up
};

/// Deforms a cell isotropically by damped dynamics at the rate g (p_d - p), g
/// as in ServoGain, until the pressure is reached at rest. `unsettled` if the
/// goal is not met in the steps allowed; then the cell is where it came to.
/// @param observe  told of the cell every few thousand time steps, with the
///                 evaluations since; may be empty
/// Source: Sheng et al. (2004), eqs (7) and (8).
CellAnswer servo_to_pressure(UnitCell &cell,
                             const ServoGoal &goal,
                             const Dynamics &settings,
                             const Arithmetic &arithmetic = {},
                             const CompressionObserver &observe = {});
} // namespace tamp::dem

#endif
