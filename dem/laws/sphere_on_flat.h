// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_sphere_on_flat_h
#define dem_laws_sphere_on_flat_h

#include <dem/laws/pair_law.h>
#include <dem/value_check.h>

#include <numbers>

namespace tamp::dem
{
/// A sphere on a rigid flat, at the largest overlap that it has seen.
template <class V>
struct FlatPeak {
  V overlap;  ///< delta_max [m]
  V radius;   ///< a_max of the contact [m]
  V force;    ///< N_max [N]
  V recovery; ///< delta_max - delta_p, what full unloading gives back [m]
};

/// An elastic-plastic sphere pressed by a rigid flat to large strains, by the
/// method of dimensionality reduction.
///
/// Up to delta_Y it is Hertz's. Beyond, the mean pressure is
/// p_Y = Y (1 + 1.75 exp(-4.4 delta_max / R)) on the area
/// pi a_max^2 = pi (2 delta_max R - delta_max^2 + delta_Y^2 - delta_Y R), and
/// unloading is that of a flat punch of radius a_max:
/// N = N_max 2/pi (arccos y - y sqrt(1 - y^2)), a = a_max sqrt(1 - y^2),
/// y = (delta_max - delta) / (delta_max - delta_p), of Mesarovic & Johnson,
/// whose recovery 2 p_Y a_max / E_c is made smaller by the finite height of the
/// sphere: times 1 + 2 delta_R / A in the notation of the source.
///
/// The published elastic branch has a semi-elliptical indenter instead of
/// Hertz's parabola. It is softer by at most half a per cent at
/// E / Y = 20, less for harder grains, and leaves a jump of that size at
/// delta_Y, since yield is defined by Hertz's pressure; this one is continuous.
/// Sources: Zunker & Kamrin (2024), J. Mech. Phys. Solids 183:105492 and
/// 105493; Mesarovic & Johnson (2000), J. Mech. Phys. Solids 48:2009.
class SphereOnFlat
{
public:
  /// Side overlaps end here, as a share of the radius [-].
  static constexpr double overlap_limit = 0.95;

  /// @param youngs_modulus  E [Pa]
  /// @param poisson_ratio   nu [-], above -1 and below 0.5
  /// @param yield_stress    Y [Pa]; so high that the sphere stays elastic up
  ///                        to half its radius, it is refused
  SphereOnFlat(double youngs_modulus, double poisson_ratio, double yield_stress)
      : modulus_(youngs_modulus / (1 - poisson_ratio * poisson_ratio)),
        yield_stress_(yield_stress),
        lateral_((1 - 2 * poisson_ratio) / (2 * (1 - poisson_ratio))),
        yield_ratio_(find_yield_ratio(modulus_, yield_stress))
  {
    if (!(youngs_modulus > 0))
      refuse("Young's modulus", youngs_modulus, "positive");
    if (!(poisson_ratio > -1 && poisson_ratio < 0.5))
      refuse("Poisson's ratio", poisson_ratio, "above -1 and below 0.5");
    if (!(yield_stress > 0 && yield_ratio_ < 0.5))
      refuse("Yield stress",
             yield_stress,
             "positive and below about 0.4 of Young's modulus");
  }

  /// E_c = E / (1 - nu^2) [Pa].
  double modulus() const { return modulus_; }
  /// delta_Y / R [-].
  double yield_ratio() const { return yield_ratio_; }

  /// p_Y at delta_max / R [Pa].
  template <class V>
  V flow_pressure(const V &ratio) const
  {
    return V(yield_stress_) *
           (V(1.0) + V(1.75) * negative_exponential(V(-4.4) * ratio));
  }

  /// Area of the flat that the geometry of the sphere asks for [m2]:
  /// pi delta R, or past yield pi (2 delta R - delta^2 + delta_Y^2 - delta_Y
  /// R).
  template <class V>
  V area(const V &overlap, const V &largest, const V &radius) const
  {
    const V elastic = overlap * radius;
    const V plastic = overlap * (V(2.0) * radius - overlap) -
                      V(yield_ratio_ * (1 - yield_ratio_)) * radius * radius;
    const auto yielded = largest > V(yield_ratio_) * radius;
    return V(std::numbers::pi) * max(V(0.0), select(yielded, plastic, elastic));
  }

  /// The state at a largest overlap of 0 to overlap_limit times the radius.
  template <class V>
  FlatPeak<V> peak(const V &largest, const V &radius) const
  {
    const V ratio =
        min(max(largest / radius, V(yield_ratio_)), V(overlap_limit));
    const V pressure = flow_pressure(ratio);
    const V a = radius * sqrt(ratio * (V(2.0) - ratio) -
                              V(yield_ratio_ * (1 - yield_ratio_)));
    const V punch = V(2 / modulus_) * pressure * a; // A / 2
    // 1 + 2 delta_R / A: the elasticity E and G of the source cancels.
    const V height = (radius * (V(1.0) - ratio) + punch) / a;
    const V slant = sqrt(V(1.0) + height * height);
    const V share =
        V(1.0) - (V(1.0) - V(lateral_) * height / (slant + height)) / slant;

    const V hertz_radius = sqrt(radius * largest);
    const auto yielded = largest > V(yield_ratio_) * radius;
    return {largest,
            select(yielded, a, hertz_radius),
            select(yielded,
                   V(std::numbers::pi) * pressure * a * a,
                   V(4.0 / 3 * modulus_) * largest * hertz_radius),
            select(yielded, punch * share, largest)};
  }

  /// Force and contact radius at an overlap up to the largest one; zero where
  /// they have parted.
  template <class V>
  NormalAnswer<V>
  push(const V &overlap, const FlatPeak<V> &peak, const V &radius) const
  {
    const V y = unloaded(overlap, peak);
    const V x = sqrt(V(1.0) - y * y);
    const V delta = max(overlap, V(0.0));
    const V hertz_radius = sqrt(radius * delta);
    const auto yielded = peak.overlap > V(yield_ratio_) * radius;
    return {select(yielded,
                   V(2 / std::numbers::pi) * peak.force *
                       max(V(0.0), arc_cosine(y) - y * x),
                   V(4.0 / 3 * modulus_) * delta * hertz_radius),
            select(yielded, peak.radius * x, hertz_radius),
            V(0.0)};
  }

  /// Work that full unloading gives back [J], the exact integral of push().
  double
  stored_work(double overlap, const FlatPeak<double> &peak, double radius) const
  {
    if (peak.overlap <= yield_ratio_ * radius)
      return 0.4 * push(overlap, peak, radius).force * max(overlap, 0.0);
    const double y = unloaded(overlap, peak), x = std::sqrt(1 - y * y);
    return 2 / std::numbers::pi * peak.force * peak.recovery *
           max(0.0, x - y * std::acos(y) - x * x * x / 3);
  }

private:
  // y: 0 at the largest overlap, 1 where the contact ends.
  template <class V>
  static V unloaded(const V &overlap, const FlatPeak<V> &peak)
  {
    return min(
        V(1.0),
        max(V(0.0), (peak.overlap - overlap) / max(peak.recovery, V(tiny))));
  }

  // Root of 4 E_c sqrt(x) / (3 pi) = p_Y(x), by bisection; 1 if there is none.
  static double find_yield_ratio(double modulus, double yield_stress)
  {
    double low = 0, high = 1;
    for (int half = 0; half < 200; ++half) {
      const double x = 0.5 * (low + high);
      const double hertz = 4 * modulus * std::sqrt(x) / (3 * std::numbers::pi);
      (hertz < yield_stress * (1 + 1.75 * std::exp(-4.4 * x)) ? low : high) = x;
    }
    return high;
  }

  double modulus_;      // E_c
  double yield_stress_; // Y
  double lateral_;      // (1 - 2 nu) / (2 (1 - nu))
  double yield_ratio_;  // delta_Y / R
};
} // namespace tamp::dem

#endif
