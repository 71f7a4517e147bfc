// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_cap_geometry_h
#define apps_fit_cap_geometry_h

#include <optional>
#include <span>

namespace tamp::apps
{
/// A stress in the p-q plane, compression positive [Pa].
struct StressPoint {
  double p = 0, q = 0;
};

/// The shear line q = d + p tan(beta) of a Drucker-Prager cap.
struct ShearLine {
  double cohesion = 0; ///< d, not negative [Pa]
  double slope = 0;    ///< tan(beta) [-]
  /// All points have one pressure: the line was drawn through q = p = 0.
  bool through_origin = false;

  double at(double p) const { return cohesion + slope * p; }
};

/// The line with the least squares of relative differences in q; without
/// cohesion if that would be negative, or if pressures differ by less than a
/// tenth. @param points  at least one, q above zero.
ShearLine fit_shear_line(std::span<const StressPoint> points);

/// Standard error of the cohesion of such a line, from the scatter of the
/// points about it [Pa]; zero with fewer than three points, or if all have one
/// pressure.
double cohesion_error(std::span<const StressPoint> points);

/// Root mean square of (q - line) / line at points.
double residual_of(const ShearLine &line, std::span<const StressPoint> points);

/// What closes a shear line: an ellipse about (p_a, 0) that begins on the line
/// and ends at p_b, without a transition (alpha = 0).
struct Cap {
  double centre = 0;         ///< p_a [Pa]
  double eccentricity = 0;   ///< R [-]
  double yield_pressure = 0; ///< p_b [Pa]
};

/// The cap that goes through a stress under which plastic compaction is
/// `plastic_ratio` times plastic shear, with flow normal to it: from R^2 =
/// (p - p_a) / (ratio q) and the ellipse,
///   tan(beta)^2 p_a^2 + (2 d tan(beta) + ratio q) p_a
///     + d^2 - ratio p q - q^2 = 0.
/// With ratio = 3/2, lateral plastic strain zero, the rule of die calibration
/// (J. C. Cunningham et al., Powder Technology 140 (2004)). None if the stress
/// is above the line.
std::optional<Cap> cap_by_flow(const ShearLine &line,
                               const StressPoint &stress,
                               double plastic_ratio);

/// The cap of a given eccentricity that goes through a stress. None if the
/// stress is above the line.
std::optional<Cap> cap_through(const ShearLine &line,
                               double eccentricity,
                               const StressPoint &stress);
} // namespace tamp::apps

#endif
