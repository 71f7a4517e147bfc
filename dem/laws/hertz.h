// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_hertz_h
#define dem_laws_hertz_h

#include <dem/laws/pair_law.h>

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
/// Two elastic spheres without friction or adhesion.
/// Source: Hertz (1882); K. L. Johnson, Contact Mechanics (1985), ch. 4.
struct Hertz {
  double effective_modulus; ///< E* [Pa]

  /// N = 4/3 E* sqrt(R*) delta^(3/2), a = sqrt(R* delta).
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
    const V a = sqrt(reduced_radius * delta);
    return {V(4.0 / 3 * effective_modulus) * a * delta, a};
  }

  /// dN/d delta [N/m].
  double loading_slope(double overlap, double reduced_radius, double) const
  {
    return 2 * effective_modulus *
           std::sqrt(reduced_radius * std::max(overlap, 0.0));
  }
  /// dN/d delta of an unloading from the largest overlap [N/m].
  double steepest_slope(double reduced_radius, double largest_overlap) const
  {
    return loading_slope(largest_overlap, reduced_radius, largest_overlap);
  }
  bool is_plastic(double, double) const { return false; }

  /// U = 8/15 E* sqrt(R*) delta^(5/2).
  NormalEnergy
  energy(double overlap, double reduced_radius, double largest_overlap) const
  {
    const double delta = std::max(overlap, 0.0);
    return {0.4 * delta * (*this)(delta, reduced_radius, largest_overlap).force,
            0};
  }
};
} // namespace tamp::dem

#endif
