// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_adhesive_mindlin_h
#define dem_laws_adhesive_mindlin_h

#include <dem/laws/mindlin.h>

namespace tamp::dem
{
/// Tangential force of an adhesive contact: Mindlin's no-slip stiffness of a
/// contact radius that the tangential force itself peels down, and a cap that
/// counts the pull of adhesion. Without adhesion it is Mindlin's law.
///
/// Peeling: a^3 = 3 R*/(4 E*) [N + 2 N_c + sqrt(4 N_c (N + N_c) -
/// T^2 E*/(4 G*))], with N_c the pull-off force; it ends at
/// T_c = 4 sqrt(N_c (N + N_c) G*/E*), where the root vanishes. R* may be that
/// of a contact flattened by plasticity: only the ratio to the radius without
/// a tangential force is used.
/// Source: Savkoor & Briggs (1977), Proc. R. Soc. A 356:103; Thornton & Yin
/// (1991), Powder Technol. 65:153; cap: Thornton (1991), J. Phys. D 24:1942.
struct AdhesiveMindlin {
  static constexpr int more = 0; ///< numbers of its own in the memory

  double effective_modulus;       ///< E* [Pa]
  double effective_shear_modulus; ///< G* [Pa]
  double friction_coefficient;    ///< mu [-]

  /// k_t of a contact radius [N/m].
  template <class V>
  V stiffness(const V &contact_radius) const
  {
    return V(8 * effective_shear_modulus) * contact_radius;
  }
  /// Largest tangential force, mu (N + 2 N_c) [N].
  template <class V>
  V cap(const NormalAnswer<V> &push) const
  {
    return V(friction_coefficient) *
           max(push.force + V(2.0) * push.pull_off, V(0.0));
  }

  /// Contact radius under a tangential force [m].
  /// @param square  T^2 [N^2]
  template <class V>
  V peeled_radius(const NormalAnswer<V> &push, const V &square) const
  {
    const V base = push.force + V(2.0) * push.pull_off;
    const V most =
        max(V(0.0), V(4.0) * push.pull_off * (push.force + push.pull_off));
    const V left = max(
        V(0.0),
        most - V(effective_modulus / (4 * effective_shear_modulus)) * square);
    const V share =
        max(V(0.0), base + sqrt(left)) / max(base + sqrt(most), V(tiny));
    return push.contact_radius * cube_root(min(V(1.0), share));
  }

  /// As Mindlin's, with dT = 8 G* a(T) d slip integrated over the increment:
  /// the force moves along a line, on which Simpson's rule gives the mean of
  /// 1/a. Since a depends on |T| alone, no work is gained or lost by peeling.
  /// Lost is as in Mindlin's law, energies being those of the mean radius.
  template <class V>
  TangentialAnswer<V>
  operator()(const Triple<V> &old_force, const ContactMotion<V> &now, V *) const
  {
    const NormalAnswer<V> &push = now.push;
    const V change = push.contact_radius / max(now.old_radius, V(tiny));
    const Triple<V> kept =
        min(V(1.0), change) * turned(old_force, now.normal, now.spin);
    const Triple<V> slip = across(now.slip, now.normal);
    const V start = peeled_radius(push, dot(kept, kept));
    V radius = start;
    for (int pass = 0; pass < passes; ++pass) {
      const Triple<V> step = stiffness(radius) * slip;
      const Triple<V> half = kept + V(0.5) * step, end = kept + step;
      const V middle = peeled_radius(push, dot(half, half));
      const V last = peeled_radius(push, dot(end, end));
      const V sum = V(1.0) / max(start, V(tiny)) +
                    V(4.0) / max(middle, V(tiny)) + V(1.0) / max(last, V(tiny));
      radius = select(start > V(tiny), V(6.0) / sum, V(0.0));
    }
    const V k = stiffness(radius);
    const Triple<V> tried = kept + k * slip;
    const V size = sqrt(dot(tried, tried));
    const V limit = cap(push);
    const V share = min(V(1.0), limit / max(size, V(tiny)));
    // What a limit below the kept force takes, and an opening contact.
    const V beyond = max(sqrt(dot(kept, kept)) - limit, V(0.0));
    const V slid = limit * max(size - limit, V(0.0)) + V(0.5) * beyond * beyond;
    const V peeled = select(push.contact_radius > V(tiny),
                            radius / max(push.contact_radius, V(tiny)),
                            V(1.0));
    const V old_stiffness = stiffness(now.old_radius * peeled);
    const V stored =
        V(0.5) * (dot(old_force, old_force) / max(old_stiffness, V(tiny)) -
                  dot(kept, kept) / max(k, V(tiny)));
    return {share * tried, slid / max(k, V(tiny)) + stored};
  }

  /// Integral of T dT / (8 G* a(T)), by Simpson's rule [J].
  double stored(const Triple<double> &force,
                const NormalAnswer<double> &push,
                const double *) const
  {
    const double square = dot(force, force);
    const double middle = peeled_radius(push, 0.25 * square);
    const double end = peeled_radius(push, square);
    return square / 6 *
           (2 / max(stiffness(middle), tiny) + 1 / max(stiffness(end), tiny));
  }

private:
  static constexpr int passes = 3; // each leaves a tenth of the error or less
};
} // namespace tamp::dem

#endif
