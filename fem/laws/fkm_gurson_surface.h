// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_fkm_gurson_surface_h
#define fem_laws_fkm_gurson_surface_h

#include <algorithm>
#include <cmath>

namespace tamp::fem
{
/// The yield surface of a powder of metal spheres at one density; p =
/// -tr(sigma) / 3, q = sqrt(3/2 s : s), sigma_0 the yield stress of the solid,
/// f porosity.
///
///   F = (1 - w) F_FKM + w F_G
///   F_FKM = (sqrt(5) p / (3 p_y))^2 + (5 r(q) / (18 p_y) + 2/3)^2 - 1
///   F_G   = (q / sigma_0)^2 + 2 f cosh(3 p / (2 sigma_0)) - 1 - f^2
///
/// Sources: N. A. Fleck, L. T. Kuhn, R. M. McMeeking, J. Mech. Phys. Solids 40
/// (1992) 1139 (cohesive contacts); A. L. Gurson, J. Eng. Mater. Technol. 99
/// (1977) 2; the weighted sum after P. Redanz, Eur. J. Mech. A 17 (1998) 175.
///
/// The surface of FKM has a corner at q = 0, where flow is any between
/// d eps_q = 0 and d eps_v / 3. It is rounded: r(q) = c (sqrt(q^2 + a^2) - a)
/// with a = rounding times p_y, and c such that q = 1.2 p_y at p = 0 as without
/// rounding. F is convex: each of its terms is convex in p, and convex and not
/// decreasing in q.
template <class Number>
struct FkmGursonSurface {
  double solid_yield; ///< sigma_0 [Pa]
  double rounding;    ///< a / p_y [-]
  Number fkm_yield;   ///< p_y of FKM [Pa]
  Number porosity;    ///< f [-]
  Number weight;      ///< w: 0 pure FKM, 1 pure Gurson [-]

  /// F: negative inside, zero on the surface [-].
  Number yield(const Number &p, const Number &q) const
  {
    using std::cosh;
    Number result = 0.;
    if (has_fkm()) {
      const Number x = p / fkm_yield, y = height(q);
      result += (1. - weight) * (5. / 9. * x * x + y * y - 1.);
    }
    if (has_gurson()) {
      const Number y = q / solid_yield;
      result += weight * (y * y + 2. * porosity * cosh(1.5 * p / solid_yield) -
                          1. - porosity * porosity);
    }
    return result;
  }
  /// dF/dp [1/Pa].
  Number by_p(const Number &p, const Number &) const
  {
    using std::sinh;
    Number result = 0.;
    if (has_fkm())
      result += (1. - weight) * 10. / 9. * p / (fkm_yield * fkm_yield);
    if (has_gurson())
      result +=
          weight * 3. * porosity * sinh(1.5 * p / solid_yield) / solid_yield;
    return result;
  }
  /// dF/dq / q [1/Pa^2], which is regular at q = 0.
  Number by_q_over_q(const Number &, const Number &q) const
  {
    Number result = weight * 2. / (solid_yield * solid_yield);
    if (has_fkm())
      result += (1. - weight) * 5. / 9. * height(q) * scale() /
                (fkm_yield * fkm_yield * root(q));
    return result;
  }

  /// Where dF/dp = 0 [Pa].
  Number centre() const { return Number(0.); }
  /// Where the surface meets q = 0 [Pa].
  double smallest_pressure() const { return -largest_pressure(); }
  double largest_pressure() const
  {
    using std::log;
    // F is convex: Newton steps from outside approach from one side.
    double p = 0;
    if (has_fkm())
      p = fkm_yield;
    if (has_gurson())
      p = std::max(p, -2. / 3. * solid_yield * log(porosity));
    for (unsigned i = 0; i < 60; ++i) {
      const double step = yield(p, 0) / by_p(p, 0);
      p -= step;
      if (!(std::abs(step) > 1e-15 * p))
        break;
    }
    return p;
  }
  /// q on the surface; zero outside its pressures [Pa].
  double shear_limit(const double p) const
  {
    if (!(yield(p, 0) < 0))
      return 0;
    double q = 0;
    if (has_fkm())
      q = 1.2 * fkm_yield;
    if (has_gurson())
      q = std::max(q, solid_yield);
    for (unsigned i = 0; i < 60; ++i) {
      const double step = yield(p, q) / (q * by_q_over_q(p, q));
      q -= step;
      if (!(std::abs(step) > 1e-14 * q))
        break;
    }
    return q;
  }

private:
  bool has_fkm() const { return weight < 1.; }
  bool has_gurson() const { return weight > 0.; }
  /// c, so that c (sqrt(1.2^2 + a^2) - a) = 1.2 for a over p_y.
  double scale() const
  {
    return 1.2 / (std::sqrt(1.44 + rounding * rounding) - rounding);
  }
  /// sqrt(q^2 + a^2) / p_y.
  Number root(const Number &q) const
  {
    using std::sqrt;
    const Number y = q / fkm_yield;
    return Number(sqrt(y * y + rounding * rounding));
  }
  /// 5 r / (18 p_y) + 2/3.
  Number height(const Number &q) const
  {
    return Number(5. / 18. * scale() * (root(q) - rounding) + 2. / 3.);
  }
};
} // namespace tamp::fem

#endif
