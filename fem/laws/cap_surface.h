// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_cap_surface_h
#define fem_laws_cap_surface_h

#include <cmath>

namespace tamp::fem
{
/// How much a powder dilates in shear failure, see CapSurface.
enum class Dilation { full, bounded };

/// What a cap surface is built from. p and q are positive in compression:
/// p = -tr(sigma) / 3 and q = sqrt(3/2 s : s).
template <class Number>
struct CapConstants {
  Number cohesion;       ///< d [Pa], not negative
  Number friction_angle; ///< beta in the p-q plane [rad], in (0, pi/2)
  Number eccentricity;   ///< R_c [-], positive
  Number yield_pressure; ///< p_b [Pa], above -d / tan(beta)
  double transition = 0; ///< alpha [-], not negative, small
  Dilation dilation = Dilation::full;
};

/// The yield surface of the modified Drucker-Prager cap model with K = 1 at
/// given constants: from the apex on the tension side along the shear failure
/// line, over the transition arc (none if alpha = 0) to the cap.
///
///   F_s = q - p tan(beta) - d
///   F_t = sqrt((p - p_a)^2 + (q - (1 - alpha / cos(beta)) A)^2) - alpha A
///   F_c = sqrt((p - p_a)^2 + (R_c q / c)^2) - R_c A
///
/// with A = d + p_a tan(beta), c = 1 + alpha - alpha / cos(beta) and p_a =
/// (p_b - R_c d) / (1 + R_c tan(beta)). Source: Abaqus Analysis User's Guide,
/// Modified Drucker-Prager/Cap model; Drucker, Gibson and Henkel (1957).
///
/// Flow on the cap is associated. On shear and transition `full` dilation
/// follows the ellipse G_s = sqrt(((p_a - p) tan(beta))^2 + (q / c)^2) of the
/// same source: dilatant, and isochoric at p = p_a; its direction turns
/// smoothly to pure dilation towards q = 0, so the apex needs no rule of its
/// own. But where p_a tan(beta) > (2 + sqrt(8)) d (for c = 1) its plastic work
/// is negative on a part of the shear line about p_a / 4: the powder gives out
/// energy as it fails. `bounded` dilation is that of G_s times (q + d) / A: it
/// has the same limits at p_a and at the apex. On the shear line it is (1 + d /
/// q) (1 - q / A) c^2 times that of associated flow and so less than q / p, at
/// which plastic work would be zero.
template <class Number>
struct CapSurface {
  /// Rounds bounded dilation at the apex of a powder without cohesion [-].
  static constexpr double rounding = 1e-3;

  CapSurface() = default;
  explicit CapSurface(const CapConstants<Number> &constants)
      : cohesion(constants.cohesion), eccentricity(constants.eccentricity),
        transition(constants.transition), dilation_rule(constants.dilation)
  {
    using std::sqrt;
    using std::tan;
    tan_beta = tan(constants.friction_angle);
    const Number secant = sqrt(1. + tan_beta * tan_beta);
    inverse_cosine = secant;
    centre = (constants.yield_pressure - eccentricity * cohesion) /
             (1. + eccentricity * tan_beta);
    strength = cohesion + centre * tan_beta;
    factor = 1. + transition - transition * secant;
  }

  /// Half axis of the cap along p, p_b - p_a [Pa].
  Number radius() const { return Number(eccentricity * strength); }
  /// Half axis of the cap along q [Pa].
  Number top() const { return Number(factor * strength); }
  /// The pressure at the apex, where the shear line meets q = 0 [Pa].
  Number apex() const { return Number(-cohesion / tan_beta); }
  /// The pressure at which the transition arc touches the shear line [Pa].
  Number transition_begin() const
  {
    return Number(centre - transition * strength * tan_beta / inverse_cosine);
  }

  /// q on the shear line or the transition arc, for p <= p_a [Pa]; negative
  /// beyond the apex.
  Number shear_limit(const Number &p) const
  {
    using std::sqrt;
    if (transition <= 0 || p <= transition_begin())
      return Number(cohesion + p * tan_beta);
    const Number height = transition * strength, off = p - centre;
    return Number((1. - transition * inverse_cosine) * strength +
                  sqrt(height * height - off * off));
  }

  /// F_s, F_t or F_c, whichever governs at p: negative inside, zero on the
  /// surface [Pa].
  Number yield(const Number &p, const Number &q) const
  {
    using std::sqrt;
    const Number off = p - centre;
    if (off > 0.) {
      const Number height = eccentricity * q / factor;
      return Number(sqrt(off * off + height * height) - radius());
    }
    return Number(q - shear_limit(p));
  }

  /// How often the way from (p_a, 0) to the surface, in the direction of a
  /// point, fits into the way to that point: below 1 inside, 1 on the surface.
  /// Convex in (p, q) [-].
  Number gauge(const Number &p, const Number &q) const
  {
    using std::sqrt;
    const Number off = p - centre;
    if (off > 0.) {
      const Number height = eccentricity * q / factor;
      return Number(sqrt(off * off + height * height) / radius());
    }
    const Number reach = centre - transition_begin(); // of the arc along p
    if (off * (strength - reach * tan_beta) <= -reach * q)
      return Number((q - off * tan_beta) / strength);
    const Number middle = (1. - transition * inverse_cosine) * strength,
                 arc = transition * strength, square = off * off + q * q;
    return Number(square /
                  (q * middle + sqrt(q * q * middle * middle -
                                     square * (middle * middle - arc * arc))));
  }

  /// Direction of plastic flow at a point of the surface: how much compaction
  /// and how much shear, not normalised.
  struct Flow {
    Number compaction, shear;
  };
  Flow flow(const Number &p, const Number &q) const
  {
    if (p > centre) {
      const Number slimness = eccentricity / factor;
      return {Number(p - centre), Number(slimness * slimness * q)};
    }
    return {Number(-dilation(p, q)), Number(q / (factor * factor))};
  }
  /// Of a point of the shear line or the arc, for shear q / c^2 [Pa].
  Number dilation(const Number &p, const Number &q) const
  {
    const Number full = (centre - p) * tan_beta * tan_beta;
    if (dilation_rule == Dilation::full)
      return full;
    return Number(full * ((q + cohesion) / strength + rounding));
  }

  Number cohesion = 0., eccentricity = 0.; ///< d [Pa], R_c [-]
  double transition = 0;                   ///< alpha [-]
  Dilation dilation_rule = Dilation::full;
  Number tan_beta = 0., inverse_cosine = 0.;
  Number centre = 0.;   ///< p_a: where the cap begins [Pa]
  Number strength = 0.; ///< A: the shear line at p_a [Pa]
  Number factor = 0.;   ///< c [-]
};
} // namespace tamp::fem

#endif
