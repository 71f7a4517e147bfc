// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_thornton_ning_h
#define dem_laws_thornton_ning_h

#include <dem/laws/pair_law.h>

#include <algorithm>
#include <numbers>

namespace tamp::dem
{
/// Elastic spheres whose contact pressure is cut off at the limiting contact
/// pressure p_y. The virgin curve is Hertz's up to delta_y and a straight line
/// beyond; unloading and reloading follow Hertz with a larger radius R_p* and a
/// permanent overlap delta_p.
///
/// With delta* = max(largest overlap, delta_y), F* = N(delta*) on the virgin
/// curve and a* = sqrt(R* delta*), all branches are one:
/// rho = max(0, 1 + (delta - delta*) 4 E* a* / (3 F*)), N = F* rho^(3/2),
/// a = a* sqrt(rho).
/// Source: Thornton (1997), J. Appl. Mech. 64:383; Thornton & Ning (1998),
/// Powder Technol. 99:154.
struct ThorntonNing {
  double effective_modulus; ///< E* [Pa]
  double limiting_pressure; ///< p_y [Pa]

  /// delta_y = R* (pi p_y / (2 E*))^2 [m].
  template <class V>
  V yield_overlap(const V &reduced_radius) const
  {
    return reduced_radius * V(yield_ratio());
  }

  /// F* on the virgin curve at delta* >= delta_y:
  /// N_y + pi p_y R* (delta* - delta_y) [N].
  template <class V>
  V virgin_force(const V &overlap, const V &reduced_radius) const
  {
    const double y = yield_ratio();
    const double slope = std::numbers::pi * limiting_pressure;
    const double offset =
        y * (4.0 / 3 * effective_modulus * std::sqrt(y) - slope);
    return reduced_radius * (V(slope) * overlap + V(offset) * reduced_radius);
  }

  /// Force and contact radius at an overlap.
  /// @param overlap          delta [m]; zero or negative gives zero force
  /// @param reduced_radius   R* [m]
  /// @param largest_overlap  in: largest so far, out: this one included [m]
  template <class V>
  NormalAnswer<V> operator()(const V &overlap,
                             const V &reduced_radius,
                             V &largest_overlap) const
  {
    using std::max, std::sqrt;
    const V delta = max(overlap, V(0.0));
    largest_overlap = max(largest_overlap, delta);
    const V peak = max(largest_overlap, yield_overlap(reduced_radius));
    const V peak_radius = sqrt(reduced_radius * peak);
    const V peak_force = virgin_force(peak, reduced_radius);
    const V rho = max(V(0.0),
                      V(1.0) + (delta - peak) * V(4.0 / 3 * effective_modulus) *
                                   peak_radius / peak_force);
    const V root = sqrt(rho);
    return {peak_force * rho * root, peak_radius * root};
  }

  /// dN/d delta for further loading: pi p_y R* on the plastic part of the
  /// virgin curve, 2 E* a elsewhere [N/m].
  double loading_slope(double overlap,
                       double reduced_radius,
                       double largest_overlap) const
  {
    const double peak =
        std::max({largest_overlap, overlap, yield_overlap(reduced_radius)});
    if (overlap >= peak)
      return std::numbers::pi * limiting_pressure * reduced_radius;
    return 2 * effective_modulus *
           (*this)(overlap, reduced_radius, largest_overlap).contact_radius;
  }
  /// dN/d delta of an unloading from the largest overlap, 2 E* a* [N/m].
  double steepest_slope(double reduced_radius, double largest_overlap) const
  {
    return 2 * effective_modulus *
           std::sqrt(reduced_radius *
                     std::max(largest_overlap, yield_overlap(reduced_radius)));
  }
  /// Whether the contact has yielded.
  bool is_plastic(double reduced_radius, double largest_overlap) const
  {
    return largest_overlap > yield_overlap(reduced_radius);
  }

  /// Elastic energy 2/5 N (delta - delta_p), and the loss: work of the virgin
  /// curve up to delta* less what full unloading gives back.
  NormalEnergy
  energy(double overlap, double reduced_radius, double largest_overlap) const
  {
    const double y = yield_overlap(reduced_radius);
    const double peak = std::max({largest_overlap, overlap, y});
    const double peak_force = virgin_force(peak, reduced_radius);
    const double recovered = // delta* - delta_p
        0.75 * peak_force /
        (effective_modulus * std::sqrt(reduced_radius * peak));
    const double force =
        (*this)(overlap, reduced_radius, largest_overlap).force;
    const double above = peak - y,
                 yield_force = virgin_force(y, reduced_radius);
    const double work =
        0.4 * yield_force * y + 0.5 * (yield_force + peak_force) * above;
    return {0.4 * force * std::max(0.0, overlap - (peak - recovered)),
            work - 0.4 * peak_force * recovered};
  }

private:
  /// delta_y / R*.
  double yield_ratio() const
  {
    const double root =
        std::numbers::pi * limiting_pressure / (2 * effective_modulus);
    return root * root;
  }
};
} // namespace tamp::dem

#endif
