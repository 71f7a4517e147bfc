// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_time_step_h
#define dem_time_step_h

#include <dem/grain_material.h>

namespace tamp::dem
{
/// Rayleigh time step pi R_min / alpha sqrt(rho / G) [s], with
/// alpha = 0.1631 nu + 0.876605. Source: Sheng et al. (2004), eqs (3)-(6).
double rayleigh_time_step(const GrainMaterial &material,
                          double smallest_radius,
                          double density_scaling);

/// Largest stable step of the leapfrog for an oscillator whose dashpot feels
/// the velocity half a step late, as that of a contact does [s]:
/// dt = 2/omega [sqrt(1 + zeta^2) - zeta]; infinite without stiffness.
/// With h = omega dt a step multiplies the motion by the roots of
/// z^2 - (2 - 2 zeta h - h^2) z + 1 - 2 zeta h; the first to leave the unit
/// circle leaves at z = -1, where h^2 + 4 zeta h = 4. Damping that is centred
/// between two half steps, as the global damping is, adds
/// zeta h (z^2 - 1) instead: nothing at z = -1, and the bound is 2/omega at any
/// zeta.
/// A contact of damping ratio beta damps the fastest motion of a grain that
/// has Z such contacts by a ratio of about beta sqrt(Z), because stiffness and
/// dashpots add up but their ratio goes with a root.
/// @param frequency      omega [rad/s]
/// @param damping_ratio  zeta of the late dashpot [-]
double stable_time_step(double frequency, double damping_ratio);
} // namespace tamp::dem

#endif
