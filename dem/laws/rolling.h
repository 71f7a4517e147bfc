// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_rolling_h
#define dem_laws_rolling_h

#include <dem/laws/pair_law.h>
#include <dem/laws/turning.h>

namespace tamp::dem
{
/// How two grains in contact turned since the memory was written.
template <class V>
struct RollingMotion {
  PairShape<V> pair;
  Triple<V> normal;     ///< n, unit vector from the first grain to the second
  Triple<V> rotation;   ///< of the first grain relative to the second [rad]
  V spin;               ///< rotation of the grains about n, their mean
                        ///< by radius [rad]
  V old_radius;         ///< a when the memory was written [m]
  NormalAnswer<V> push; ///< the normal contact now
};

/// What a rolling law answers.
template <class V>
struct RollingAnswer {
  Triple<V> moment; ///< on the first grain, its opposite on the second [N m]
  V lost_work;      ///< turned into heat since the memory was written [J]
};

/// Resistance to rolling and twisting: a spring that slips at a largest
/// moment, each. The memory is the moment: its part along the normal twists,
/// its part across rolls.
///
/// Rolling: k_r = 2.25 k_n (mu_r R*)^2 with k_n = 2 E* a, the tangent of the
/// normal force; at most mu_r R* N. Twisting: k_w = 4 G* a^3, at most
/// 2/3 mu a N. Both parts turn with the contact. Where the contact radius
/// fell, they shrink with their stiffness, so that no energy is made. There is
/// no viscous part. Lost is the work of slipping, and what a change of the
/// stiffness or of the limit takes off the energy M^2 / (2 k) of the old
/// moment; all of it where the contact opens. Source: rolling: Iwashita & Oda
/// (1998), J. Eng. Mech. 124:285; Ai et al. (2011), Powder Technol. 206:269,
/// model C; twisting: Marshall (2009), J. Comput. Phys. 228:1541.
struct Rolling {
  /// The normal when the memory was written; zeros for a new contact.
  static constexpr int more = 3;

  double effective_modulus;       ///< E* [Pa]
  double effective_shear_modulus; ///< G* [Pa]
  double rolling_friction;        ///< mu_r [-]; 0 for no rolling resistance
  double friction_coefficient;    ///< mu [-]; 0 for no twisting resistance

  /// k_r [N m/rad].
  template <class V>
  V rolling_stiffness(const PairShape<V> &pair, const V &contact_radius) const
  {
    const V arm = V(rolling_friction) * pair.reduced_radius;
    return V(4.5 * effective_modulus) * contact_radius * arm * arm;
  }
  /// Largest rolling moment [N m].
  template <class V>
  V rolling_cap(const PairShape<V> &pair, const NormalAnswer<V> &push) const
  {
    return V(rolling_friction) * pair.reduced_radius * max(push.force, V(0.0));
  }
  /// k_w [N m/rad].
  template <class V>
  V twisting_stiffness(const V &contact_radius) const
  {
    return V(4 * effective_shear_modulus) * contact_radius * contact_radius *
           contact_radius;
  }
  /// Largest twisting moment [N m].
  template <class V>
  V twisting_cap(const NormalAnswer<V> &push) const
  {
    return V(2.0 / 3 * friction_coefficient) * push.contact_radius *
           max(push.force, V(0.0));
  }

  /// The moment now, from the one in the memory and the whole rotation since.
  template <class V>
  RollingAnswer<V> operator()(const Triple<V> &old_moment,
                              const RollingMotion<V> &now,
                              V *own) const
  {
    const Triple<V> &n = now.normal, m{own[0], own[1], own[2]};
    const V radius = now.push.contact_radius;
    const V old_twist = dot(old_moment, m), turn = dot(now.rotation, n);
    const Triple<V> rolled = turned(old_moment - old_twist * m, n, now.spin);
    const RollingAnswer<V> roll =
        slip(rolled,
             across(now.rotation, n),
             {rolling_stiffness(now.pair, now.old_radius),
              rolling_stiffness(now.pair, radius),
              rolling_cap(now.pair, now.push)});
    const RollingAnswer<V> twist = slip(old_twist * n,
                                        turn * n,
                                        {twisting_stiffness(now.old_radius),
                                         twisting_stiffness(radius),
                                         twisting_cap(now.push)});
    own[0] = n.x, own[1] = n.y, own[2] = n.z;
    return {roll.moment + twist.moment, roll.lost_work + twist.lost_work};
  }

  /// Energy M^2 / (2 k) of both moments [J].
  /// @param normal  that the moment was written with
  double stored(const Triple<double> &moment,
                const Triple<double> &normal,
                const PairShape<double> &pair,
                double contact_radius) const
  {
    const double twist = dot(moment, normal);
    const Triple<double> roll = across(moment, normal);
    return 0.5 *
           (dot(roll, roll) /
                max(rolling_stiffness(pair, contact_radius), tiny) +
            twist * twist / max(twisting_stiffness(contact_radius), tiny));
  }

private:
  /// A spring, before and now, and the largest moment that it bears.
  template <class V>
  struct Spring {
    V old_stiffness, stiffness, limit;
  };

  /// The spring opposes a rotation up to the limit.
  template <class V>
  static RollingAnswer<V>
  slip(const Triple<V> &old, const Triple<V> &rotation, const Spring<V> &spring)
  {
    const V k = max(spring.stiffness, V(tiny)), limit = spring.limit;
    const V change =
        select(spring.old_stiffness > V(tiny),
               spring.stiffness / max(spring.old_stiffness, V(tiny)),
               V(0.0)); // no overflow at a new contact
    const Triple<V> kept = min(V(1.0), change) * old;
    const Triple<V> tried = kept - spring.stiffness * rotation;
    const V size = sqrt(dot(tried, tried)), old2 = dot(old, old);
    const V kept2 = dot(kept, kept);
    const V beyond = max(sqrt(kept2) - limit, V(0.0));
    const V slid = limit * max(size - limit, V(0.0));
    const V taken = old2 * change - kept2;
    const auto open = spring.stiffness <= V(0.0);
    const V lost = select(open,
                          V(0.5) * old2 / max(spring.old_stiffness, V(tiny)),
                          (slid + V(0.5) * (beyond * beyond + taken)) / k);
    return {min(V(1.0), limit / max(size, V(tiny))) * tried, lost};
  }
};
} // namespace tamp::dem

#endif
