// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_viscous_h
#define dem_laws_viscous_h

#include <dem/laws/pair_law.h>
#include <dem/value_check.h>

namespace tamp::dem
{
/// What the damping of a contact depends on.
template <class V>
struct ViscousMotion {
  PairShape<V> pair;
  Triple<V> normal;     ///< n, unit vector from the first grain to the second
  Triple<V> velocity;   ///< of the surfaces, second less first [m/s]
  NormalAnswer<V> push; ///< the elastic normal contact
  Triple<V> force;      ///< T, the elastic tangential force on the first [N]
  V cap;                ///< largest tangential force, that of N + N_d [N]
  V stiffness;          ///< k_t = 8 G* a, of the tangential law [N/m]
};

/// What damping answers.
template <class V>
struct ViscousAnswer {
  Triple<V> force; ///< on the first grain, on top of the elastic force [N]
  Triple<V> kept;  ///< T to remember: the whole tangential force where it
                   ///< slides, else the elastic one [N]
};

/// Dashpots beside the springs of a contact, which give an impact of elastic
/// spheres the coefficient of restitution e at any speed.
///
/// N_d = 2 beta sqrt(2 E* a m*) d overlap/dt, T_d = 2 beta sqrt(8 G* a m*)
/// times the slip velocity. Spring and dashpot together stay below the cap of
/// friction; where they reach it, the contact slides. Damping never pulls: N +
/// N_d is not below zero (not below the pull-off force where there is
/// adhesion), which ends an impact before the overlap does. Source: Tsuji,
/// Tanaka & Ishida (1992), Powder Technol. 71:239; end of the contact: Schwager
/// & Poeschel (2007), Granul. Matter 9:465.
class Viscous
{
public:
  /// @param effective_modulus  E* [Pa]
  /// @param restitution  e [-], above 0 and up to 1, where nothing is damped
  /// Throws std::invalid_argument for a value out of range.
  Viscous(double effective_modulus, double restitution)
      : effective_modulus_(effective_modulus), beta_(damping_ratio(restitution))
  {
    Positive{}(effective_modulus, "effective modulus");
  }

  double damping() const { return beta_; } ///< beta [-]

  /// beta that leads to a coefficient of restitution e.
  ///
  /// With y = overlap^(5/4) and dt' = overlap^(1/4) dt an impact is a linear
  /// oscillator of damping ratio zeta = beta sqrt(6/5). It ends where its
  /// acceleration vanishes, at twice the angle arccos(zeta), so that
  /// e = exp(-2 zeta arccos(zeta) / sqrt(1 - zeta^2)), and with the hyperbolic
  /// functions above zeta = 1. Antypov & Elliott (2011), Europhys. Lett.
  /// 94:50004, have the substitution.
  static double damping_ratio(double restitution)
  {
    if (!(restitution > 0 && restitution <= 1))
      refuse("restitution", restitution, "above 0 and at most 1");
    double low = 0, high = 1;
    while (rebound(high) > restitution)
      high *= 2;
    for (int halving = 0; halving < 100; ++halving) {
      const double middle = 0.5 * (low + high);
      (rebound(middle) > restitution ? low : high) = middle;
    }
    return std::sqrt(5.0 / 6) * 0.5 * (low + high);
  }

  /// N_d [N]: what damping adds to the normal force. Friction is that of the
  /// whole normal force: a tangential law is to get N + N_d as its push.
  /// @param closing  d overlap/dt [m/s]
  template <class V>
  V normal_force(const PairShape<V> &pair,
                 const NormalAnswer<V> &push,
                 const V &closing) const
  {
    const V slope = V(2 * effective_modulus_) * push.contact_radius;
    const V floor = min(V(0.0), V(0.0) - push.force - push.pull_off);
    return max(rate(pair, slope) * closing, floor);
  }

  /// Damping of a contact whose elastic forces are known.
  template <class V>
  ViscousAnswer<V> operator()(const ViscousMotion<V> &now) const
  {
    const V closing = V(0.0) - dot(now.velocity, now.normal);
    const V normal = normal_force(now.pair, now.push, closing);
    const Triple<V> rub = now.force + rate(now.pair, now.stiffness) *
                                          across(now.velocity, now.normal);
    const V size = sqrt(dot(rub, rub));
    const V share = min(V(1.0), now.cap / max(size, V(tiny)));
    const Triple<V> whole = share * rub;
    const V slides = select(size > now.cap, V(1.0), V(0.0));
    return {whole - now.force - normal * now.normal,
            now.force + slides * (whole - now.force)};
  }

private:
  static double rebound(double zeta)
  {
    const double rest = std::sqrt(std::abs(1 - zeta * zeta));
    if (rest < 1e-7)
      return std::exp(-2.0);
    const double angle = zeta < 1 ? std::acos(zeta) : std::acosh(zeta);
    return std::exp(-2 * zeta * angle / rest);
  }

  /// Of a dashpot beside a spring [N s/m]; none beside a spring of zero.
  template <class V>
  V rate(const PairShape<V> &pair, const V &stiffness) const
  {
    return V(2 * beta_) * sqrt(stiffness / max(pair.inverse_mass, V(tiny)));
  }

  double effective_modulus_; // E*
  double beta_;
};
} // namespace tamp::dem

#endif
