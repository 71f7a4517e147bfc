// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_cam_clay_surface_h
#define fem_laws_cam_clay_surface_h

#include <cmath>

namespace tamp::fem
{
/// The ellipse of modified Cam-Clay, made dimensionless:
///
///   F = (q^2 / M^2 + p (p - p_c)) / p_c^2
///
/// with p = -tr(sigma) / 3 and q = sqrt(3/2 s : s). Plastic flow is normal to
/// it. Source: K. H. Roscoe, J. B. Burland, in: Engineering Plasticity (1968).
template <class Number>
struct CamClaySurface {
  double slope;          ///< M [-]
  Number yield_pressure; ///< p_c [Pa]

  /// F: negative inside, zero on the surface [-].
  Number yield(const Number &p, const Number &q) const
  {
    const Number x = p / yield_pressure, y = q / yield_pressure;
    return Number(y * y / (slope * slope) + x * (x - 1.));
  }
  /// dF/dp [1/Pa].
  Number by_p(const Number &p, const Number &) const
  {
    return Number((2. * p / yield_pressure - 1.) / yield_pressure);
  }
  /// dF/dq / q [1/Pa^2], which is regular at q = 0.
  Number by_q_over_q(const Number &, const Number &) const
  {
    return Number(2. / (slope * slope * yield_pressure * yield_pressure));
  }

  /// Where dF/dp = 0 [Pa].
  Number centre() const { return Number(0.5 * yield_pressure); }
  /// Where the surface meets q = 0 [Pa].
  Number smallest_pressure() const { return Number(0.); }
  Number largest_pressure() const { return yield_pressure; }
  /// q on the surface; zero outside its pressures [Pa].
  Number shear_limit(const Number &p) const
  {
    using std::sqrt;
    const Number square = p * (yield_pressure - p);
    return square > 0. ? Number(slope * sqrt(square)) : Number(0.);
  }
};
} // namespace tamp::fem

#endif
