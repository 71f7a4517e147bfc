// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_pair_impact_h
#define dem_pair_impact_h

#include <dem/pair_body.h>
#include <dem/pair_path.h>

#include <array>

namespace tamp::dem
{
/// What an impact comes to. Velocities are those of the first body less the
/// second, along the normal from first to second or across it.
struct Rebound {
  enum class End { going_on, parted, stuck };
  End end = End::going_on;
  double duration = 0;        ///< from the first to the last force [s]
  double largest_force = 0;   ///< normal [N]
  double largest_overlap = 0; ///< [m]
  double normal_velocity = 0; ///< below zero after a rebound [m/s]
  Triple<double> tangential_velocity{0, 0, 0}; ///< of the centres [m/s]
  Triple<double> patch_velocity{0, 0, 0}; ///< of the surfaces, across n [m/s]
  double kinetic_before = 0;              ///< of both bodies [J]
  double kinetic_after = 0;
};

/// A free impact of two bodies, which move and turn in space: velocity Verlet
/// with a constant step.
///
/// In a step the contact sees the motion of the surfaces with the velocities of
/// the middle of the step, as in a unit cell. The surfaces meet on the line of
/// the centres, which they divide in proportion to the radii; on a wall the
/// lever arm is the radius, the limit of this. Errors go with the square of the
/// step, with damping with the step.
class Impact
{
public:
  /// 1 / 4000 of the time of a Hertz contact leaves 1e-3 of a restitution with
  /// damping, 1e-5 without.
  static constexpr double default_steps = 4000;

  /// The first body is moved along z, so that the bodies just touch.
  /// @param bodies  first below second; the first is no wall
  /// @param steps   in the time of an elastic contact
  /// Throws std::invalid_argument if the bodies do not approach.
  Impact(const PairContact &contact,
         const std::array<Body, 2> &bodies,
         double steps = default_steps);

  /// One time step; false, without a step, once the bodies have parted, or turn
  /// towards each other again, stuck together by adhesion.
  bool step();

  const PairContact &contact() const { return contact_; }
  const std::array<Body, 2> &bodies() const { return bodies_; }
  double time() const { return time_; }
  double time_step() const { return step_; }
  /// How things are now.
  Rebound rebound() const;

private:
  struct Geometry {
    Triple<double> normal;
    double overlap;
    std::array<double, 2> arm;
  };
  Geometry geometry() const;
  Triple<double> surface_velocity(const Geometry &now) const;
  double closing_speed() const;
  double kinetic_energy() const;
  void kick(const Geometry &now);
  void note();

  PairContact contact_;
  std::array<Body, 2> bodies_;
  double step_ = 0, time_ = 0, longest_ = 0;
  bool touched_ = false, turned_ = false;
  Rebound rebound_;
};
} // namespace tamp::dem

#endif
