// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_adhesive_yield_h
#define dem_laws_adhesive_yield_h

#include <dem/laws/jkr.h>

namespace tamp::dem
{
/// What the largest overlap of an adhesive contact left: a pair of spheres of
/// another radius, out of place. Up to yield it is the pair itself.
template <class V>
struct Dent {
  V radius;       ///< R_p* [m]
  V root_scale;   ///< of R_p*, as Jkr::root_scale [m^(1/2)]
  V peak_overlap; ///< delta*, 0 before yield [m]
  V recovery;     ///< delta* - delta_p, 0 before yield [m]
  V peak_root;    ///< sqrt(a*), at least that of the yield point [m^(1/2)]
  V yield_root;   ///< sqrt(a_y) [m^(1/2)]

  /// delta - delta_p; no small difference of large overlaps near delta* [m].
  V over(const V &overlap) const { return overlap - peak_overlap + recovery; }
};

/// How adhesive spheres yield. Up to a_y, where the pressure in the middle of
/// the contact is the limiting contact pressure p_y, they follow JKR's law
/// (jkr.h); beyond, with a(delta) as before,
/// N = N_y + pi p_y (a^2 - a_y^2) - 2 a_y sqrt(2 pi Gamma E*) (sqrt(a) -
/// sqrt(a_y)). The pair that remains has R_p* = R*/m and delta_p =
/// a*^2 (1 - m)/R*, m = (N* + sqrt(8 pi Gamma E* a*^3)) 3 R*/(4 E* a*^3).
///
/// The ring of tension outside the yielded middle is kept as that of an elastic
/// contact, 2 a_y sqrt(2 pi Gamma E*) sqrt(a), so that its work grows as
/// a^(5/2) while the surfaces that join pay Gamma pi a^2, and yielding p_y a^4.
/// Where p_y is low, the tension wins for some a: grains that are pressed
/// together and torn apart give back more than they took. In units of JKR's
/// lengths p_y / p_a is the only number left, and the least that a path from no
/// contact to no contact can lose, over all largest overlaps, vanishes at
/// p_y = 0.4248 p_a. The law is no law below; see least_pressure().
/// Source: Thornton & Ning (1998), Powder Technol. 99:154.
class AdhesiveYield
{
public:
  /// @param effective_modulus  E* [Pa]
  /// @param limiting_pressure  p_y [Pa]
  /// @param elastic            JKR's law of the same modulus
  AdhesiveYield(double effective_modulus,
                double limiting_pressure,
                const Jkr &elastic)
      : effective_modulus_(effective_modulus), elastic_(elastic),
        limit_(0.5 * std::numbers::pi *
               min(limiting_pressure / effective_modulus, out_of_reach))
  {
  }

  /// The lowest p_y with which no closed path gains energy [Pa].
  /// @param effective_modulus  E* [Pa]
  /// @param work_of_adhesion   Gamma [J/m2]
  /// @param radius             R* [m]
  static double least_pressure(double effective_modulus,
                               double work_of_adhesion,
                               double radius);
  /// Throws std::invalid_argument if p_y is below least_pressure().
  /// @param radius  R* [m]
  void check(double radius) const;

  /// @param largest_overlap  delta* >= 0 [m]
  template <class V>
  Dent<V> dent(const V &largest_overlap, const PairShape<V> &pair) const
  {
    // Lengths of sqrt(a) over the scale: powers stay within a float's range.
    const V none(0.0), one(1.0), radius = pair.reduced_radius;
    const V scale = elastic_.root_scale(radius);
    const V over = one / (scale * scale);
    const V pull = elastic_.pull(radius, scale);
    const V limit = V(limit_) * radius * over;
    const V yield = yield_root(pull, limit);
    const V peak =
        max(yield, jkr_root(pull, (largest_overlap * over) * (radius * over)));
    const V inverse = one / peak, r = yield / peak;
    const V r2 = r * r, r4 = r2 * r2;
    const V m =
        r2 * r4 + V(1.5) * (inverse * inverse) *
                      (limit * (one - r4) + pull * inverse * (one - r2));
    const V widening = one / m;
    const V dented = radius * widening;
    const V recovery = elastic_.overlap(scale * peak, dented);
    return {dented,
            scale * quick_cube_root(widening),
            select(peak > yield, largest_overlap, none),
            select(peak > yield, recovery, none),
            scale * peak,
            scale * yield};
  }

  /// dN/d delta on the virgin curve beyond yield [N/m].
  double virgin_slope(const Dent<double> &left, double radius) const
  {
    const double suck = elastic_.suction() * radius;
    const double s = left.peak_root, y = left.yield_root;
    return 2 * effective_modulus_ *
           (4 * limit_ * radius * s * s * s - y * y * suck) /
           (4 * s * s * s - suck);
  }

  /// What yielding took: work of the virgin curve, N = A + P s^4 - B s, from
  /// s = sqrt(a_y) to sqrt(a*), and stored before, less stored after [J].
  /// It only grows if p_y > 1.4 p_a, where p_a = (2 E*^2 Gamma/(pi^2 R*))^(1/3)
  /// is the pressure that adhesion alone makes at first touch.
  double lost(const Dent<double> &left, double radius) const
  {
    const double s = left.peak_root, y = left.yield_root;
    if (s <= y)
      return 0;
    const double suction = elastic_.suction();
    const double P = 2 * effective_modulus_ * limit_;
    const double B = 2 * effective_modulus_ * suction * y * y;
    const double A = elastic_.force(y, radius) - (P * y * y * y - B) * y;
    const auto work = [&](double at) {
      const double s2 = at * at, s4 = s2 * s2;
      return A * (s4 / radius - suction * at) +
             P * s4 * (0.5 * s4 / radius - 0.2 * suction * at) -
             B * s2 * (0.8 * s2 * at / radius - 0.5 * suction);
    };
    return work(s) - work(y) + elastic_.stored(y * y, radius) -
           elastic_.stored(s * s, left.radius);
  }

private:
  static constexpr double out_of_reach = 1e3; // p_y / E* of no yielding

  /// The root t of t^3 - limit t = pull/2, that is 2 E* a_y/(pi R*) -
  /// sqrt(2 Gamma E*/(pi a_y)) = p_y. Newton from an upper bound, 7 per cent
  /// high at most, falls monotonically; four steps leave 1e-16.
  template <class V>
  static V yield_root(const V &pull, const V &limit)
  {
    V t = sqrt(limit + V(1.6));
    for (int step = 0; step < 4; ++step) {
      const V t2 = t * t;
      t = (V(2.0) * t * t2 + V(0.5) * pull) / (V(3.0) * t2 - limit);
    }
    return t;
  }

  double effective_modulus_; // E*
  Jkr elastic_;
  double limit_; // pi p_y / (2 E*)
};
} // namespace tamp::dem

#endif
