// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_wall_friction_h
#define fem_wall_friction_h

namespace tamp::fem
{
/// How a node meets the die wall.
enum class WallContact { stick, slips_up, slips_down, open };

/// Friction of a node on the wall.
struct WallForce {
  double friction = 0; ///< wall on powder, upwards [N]
  WallContact contact = WallContact::open;
};

/// Coulomb friction with elastic stick, integrated over one increment by return
/// mapping: the trial friction T_n - k s is cut to mu N.
/// @param committed  friction T_n at the start of the increment [N]
/// @param slip       s of the powder along the wall, upwards [m]
/// @param stiffness  k of the sticking contact [N/m]
/// @param limit      mu N [N]; not positive: the node does not touch the wall
/// Source: return mapping as in P. Wriggers, Computational Contact Mechanics
/// (2006).
inline WallForce
wall_friction(double committed, double slip, double stiffness, double limit)
{
  if (!(limit > 0))
    return {0., WallContact::open};
  const double trial = committed - stiffness * slip;
  if (trial > limit)
    return {limit, WallContact::slips_down};
  if (trial < -limit)
    return {-limit, WallContact::slips_up};
  return {trial, WallContact::stick};
}
} // namespace tamp::fem

#endif
