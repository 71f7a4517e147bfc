// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_mindlin_h
#define dem_laws_mindlin_h

#include <dem/laws/pair_law.h>
#include <dem/laws/turning.h>

namespace tamp::dem
{
/// Tangential force with the no-slip stiffness of Mindlin and Coulomb's cap.
/// Source: Mindlin (1949), J. Appl. Mech. 16:259, k_t = 8 G* a; unloading
/// rescale: Thornton, Cummins & Cleary (2013), Powder Technol. 233:30, eq. 18b.
struct Mindlin {
  static constexpr int more = 0; ///< numbers of its own in the memory

  double effective_shear_modulus; ///< G* [Pa]
  double friction_coefficient;    ///< mu [-]

  /// k_t [N/m].
  template <class V>
  V stiffness(const V &contact_radius) const
  {
    return V(8 * effective_shear_modulus) * contact_radius;
  }
  /// Largest tangential force [N].
  template <class V>
  V cap(const NormalAnswer<V> &push) const
  {
    return V(friction_coefficient) * max(push.force, V(0.0));
  }

  /// The old force turns with the contact, shrinks with the contact radius when
  /// the normal force fell, grows by the slip in the contact plane, and is
  /// capped at mu N. Lost is the work of sliding, and what a change of the
  /// contact radius or of the cap takes off the energy T^2 / (2 k_t) of the old
  /// force.
  template <class V>
  TangentialAnswer<V>
  operator()(const Triple<V> &old_force, const ContactMotion<V> &now, V *) const
  {
    const V radius = now.push.contact_radius;
    const Inverses<V> inverse = inverses(radius, now.old_radius);
    const V ratio = radius * inverse.second;
    const V shrink = min(V(1.0), ratio);
    const Triple<V> kept = turned(old_force, now.normal, now.spin, shrink);
    const Triple<V> tried =
        multiply_add(stiffness(radius), across(now.slip, now.normal), kept);
    const V size = sqrt(dot(tried, tried));
    const V limit = cap(now.push);
    const V share = min(V(1.0), limit / max(size, V(tiny)));
    return {share * tried,
            lost(dot(old_force, old_force),
                 dot(kept, kept),
                 size,
                 limit,
                 ratio,
                 inverse)};
  }

  /// T^2 / (2 k_t) [J].
  double stored(const Triple<double> &force,
                const NormalAnswer<double> &push,
                const double *) const
  {
    return 0.5 * dot(force, force) / max(stiffness(push.contact_radius), tiny);
  }

private:
  /// Work of sliding at the limit from the kept force on, what a limit below
  /// the kept force takes, and what the radius takes off the old force [J]. A
  /// contact that opens loses all the energy of the old force.
  /// A limit that falls by less than a thousandth takes next to nothing.
  /// @param old2, kept2  squares of the forces [N2]
  /// @param ratio        of the contact radius to the old one; 0 if open
  /// @param inverse      of these radii [1/m]
  template <class V>
  V lost(const V &old2,
         const V &kept2,
         const V &size,
         const V &limit,
         const V &ratio,
         const Inverses<V> &inverse) const
  {
    V twice =
        multiply_add(old2, ratio, V(2.0) * limit * max(size - limit, V(0.0))) -
        kept2;
    const auto falls = kept2 > V(1.002) * limit * limit;
    if (any(falls)) {
      const V beyond = sqrt(kept2) - limit;
      twice += select(falls, beyond * beyond, V(0.0));
    }
    return V(1 / (16 * effective_shear_modulus)) *
           select(ratio > V(0.0), twice * inverse.first, old2 * inverse.second);
  }
};

/// Smooth grains.
struct NoTangentialForce {
  static constexpr int more = 0;

  template <class V>
  V stiffness(const V &) const
  {
    return V(0.0);
  }
  template <class V>
  V cap(const NormalAnswer<V> &) const
  {
    return V(0.0);
  }
  template <class V>
  TangentialAnswer<V>
  operator()(const Triple<V> &, const ContactMotion<V> &, V *) const
  {
    return {{V(0.0), V(0.0), V(0.0)}, V(0.0)};
  }
  double stored(const Triple<double> &,
                const NormalAnswer<double> &,
                const double *) const
  {
    return 0;
  }
};
} // namespace tamp::dem

#endif
