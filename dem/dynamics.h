// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_dynamics_h
#define dem_dynamics_h

#include <dem/deform.h>

namespace tamp::dem
{
/// Damped motion of the grains in a cell that deforms at a constant rate of
/// stretching, as in Sheng et al. (2004), eqs (1) and (2), by leapfrog. Contact
/// memory is written every step, and work and losses are booked every step.
/// Velocities stay in the cell, so a path may be driven in pieces. The time
/// step follows the stiffness of the contacts every 1e-3 of strain; its
/// Rayleigh step is the smallest of all grains. `unsettled` if the unbalance at
/// the end is above 1e-2. Arguments as those of deform().
CellAnswer deform_by_dynamics(UnitCell &cell,
                              const Stretch &stretch,
                              const Dynamics &settings,
                              const Arithmetic &arithmetic = {});

/// The numbers by which a dynamic run is judged. The density of a mixture is
/// its mean, mass over volume of all grains, times the density scaling.
struct DynamicMeasures {
  /// strain rate x mean diameter x sqrt(density / pressure) [-]; zero without
  /// pressure.
  double inertial_number = 0;
  /// (rate^2 density R_min^2 / p_y)^(1/2) [-], with R_min the smallest radius
  /// and p_y the smallest limiting pressure of the grains. Source: Sheng et al.
  /// (2004), fig. 1, for grains of one kind.
  double scaling_number = 0;
  double kinetic_energy = 0; ///< of the fluctuations [J]
};

/// @param pressure  mean compressive stress of the cell [Pa]
DynamicMeasures measure_dynamics(const UnitCell &cell,
                                 const Dynamics &settings,
                                 double pressure);
} // namespace tamp::dem

#endif
