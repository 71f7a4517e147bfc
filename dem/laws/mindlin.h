// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_mindlin_h
#define dem_laws_mindlin_h

#include <dem/tensors.h>

#include <Eigen/Geometry>

#include <cmath>

namespace tamp::dem
{
/// How the two surfaces of a contact moved since its memory was written.
struct ContactMotion {
  Vector3 normal;        ///< n, unit vector from the first grain to the second
  Vector3 slip;          ///< relative displacement of the surfaces [m]
  double spin = 0;       ///< mean rotation of the grains about n [rad]
  double radius = 0;     ///< contact radius a now [m]
  double old_radius = 0; ///< a when the memory was written [m]
  double force = 0;      ///< normal force now [N]
};

/// Tangential force with the no-slip stiffness of Mindlin and Coulomb's cap.
/// Source: Mindlin (1949), J. Appl. Mech. 16:259, k_t = 8 G* a; unloading
/// rescale: Thornton, Cummins & Cleary (2013), Powder Technol. 233:30, eq. 18b.
struct Mindlin {
  double effective_shear_modulus; ///< G* [Pa]
  double friction_coefficient;    ///< mu [-]

  double stiffness(double contact_radius) const
  {
    return 8 * effective_shear_modulus * contact_radius;
  }

  struct Answer {
    Vector3 force;        ///< T on the first grain [N]
    double slid_work = 0; ///< dissipated by sliding [J]
  };

  /// The old force turns with the contact (its length is kept), shrinks with
  /// the contact radius when the normal force fell, grows by the slip in the
  /// contact plane, and is capped at mu N.
  Answer operator()(Vector3 force, const ContactMotion &now) const
  {
    if (now.force <= 0)
      return {Vector3::Zero(), 0};
    force = turned(force, now);
    if (now.radius < now.old_radius)
      force *= now.radius / now.old_radius;
    const double k = stiffness(now.radius);
    force += k * (now.slip - now.slip.dot(now.normal) * now.normal);
    const double size2 = force.squaredNorm();
    const double cap = friction_coefficient * now.force;
    if (size2 <= cap * cap)
      return {force, 0};
    const double size = std::sqrt(size2);
    return {force * (cap / size), cap * (size - cap) / k};
  }

private:
  static Vector3 turned(const Vector3 &force, const ContactMotion &now)
  {
    const double before = force.squaredNorm();
    Vector3 inplane = force - force.dot(now.normal) * now.normal;
    const double after = inplane.squaredNorm();
    if (after <= 0)
      return Vector3::Zero();
    inplane *= std::sqrt(before / after);
    return inplane + now.spin * now.normal.cross(inplane);
  }
};

/// Smooth grains.
struct NoTangentialForce {
  double stiffness(double) const { return 0; }
  Mindlin::Answer operator()(const Vector3 &, const ContactMotion &) const
  {
    return {Vector3::Zero(), 0};
  }
};
} // namespace tamp::dem

#endif
