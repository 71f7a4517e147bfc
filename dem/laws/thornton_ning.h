// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_thornton_ning_h
#define dem_laws_thornton_ning_h

#include <dem/laws/pair_law.h>

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
class ThorntonNing
{
public:
  static constexpr int more = 0; ///< numbers of its own in the memory

  /// @param effective_modulus  E* [Pa]
  /// @param limiting_pressure  p_y [Pa]
  ThorntonNing(double effective_modulus, double limiting_pressure)
      : effective_modulus_(effective_modulus),
        plastic_slope_(std::numbers::pi * limiting_pressure),
        yield_ratio_(plastic_slope_ * plastic_slope_ /
                     (4 * effective_modulus * effective_modulus)),
        offset_(yield_ratio_ *
                (4.0 / 3 * effective_modulus * std::sqrt(yield_ratio_) -
                 plastic_slope_))
  {
  }

  /// delta_y = R* (pi p_y / (2 E*))^2 [m].
  template <class V>
  V yield_overlap(const PairShape<V> &pair) const
  {
    return pair.reduced_radius * V(yield_ratio_);
  }

  /// F* on the virgin curve at delta* >= delta_y:
  /// N_y + pi p_y R* (delta* - delta_y) [N].
  template <class V>
  V virgin_force(const V &overlap, const PairShape<V> &pair) const
  {
    const V radius = pair.reduced_radius;
    return radius * (V(plastic_slope_) * overlap + V(offset_) * radius);
  }

  /// Force and contact radius at an overlap.
  /// @param overlap  delta [m]; zero or negative gives zero force
  template <class V>
  NormalAnswer<V> operator()(const V &overlap,
                             const PairShape<V> &pair,
                             NormalMemory<V> &memory) const
  {
    const V delta = max(overlap, V(0.0));
    memory.largest_overlap = max(memory.largest_overlap, delta);
    const V peak = max(memory.largest_overlap, yield_overlap(pair));
    const V peak_radius = sqrt(pair.reduced_radius * peak);
    const V peak_force = virgin_force(peak, pair);
    const V rho =
        max(V(0.0),
            V(1.0) + (delta - peak) * (V(4.0 / 3 * effective_modulus_) *
                                       peak_radius / peak_force));
    // Without overlap rho is 0 up to round-off only.
    const V root = select(overlap > V(0.0), sqrt(rho), V(0.0));
    return {peak_force * rho * root, peak_radius * root, V(0.0)};
  }

  /// dN/d delta for further loading: pi p_y R* on the plastic part of the
  /// virgin curve, 2 E* a elsewhere [N/m].
  double loading_slope(double overlap,
                       const PairShape<double> &pair,
                       NormalMemory<double> memory) const
  {
    const double peak = peak_overlap(pair, memory);
    if (overlap >= peak)
      return plastic_slope_ * pair.reduced_radius;
    return 2 * effective_modulus_ *
           (*this)(overlap, pair, memory).contact_radius;
  }
  /// dN/d delta of an unloading from the largest overlap, 2 E* a* [N/m].
  double steepest_slope(const PairShape<double> &pair,
                        const NormalMemory<double> &memory) const
  {
    return 2 * effective_modulus_ *
           sqrt(pair.reduced_radius * peak_overlap(pair, memory));
  }
  /// Whether the contact has yielded.
  bool is_plastic(const PairShape<double> &pair,
                  const NormalMemory<double> &memory) const
  {
    return memory.largest_overlap > yield_overlap(pair);
  }

  /// Elastic energy 2/5 N (delta - delta_p), and the loss: work of the virgin
  /// curve up to delta* less what full unloading gives back.
  NormalEnergy energy(double overlap,
                      const PairShape<double> &pair,
                      NormalMemory<double> memory) const
  {
    const double force = (*this)(overlap, pair, memory).force;
    const double y = yield_overlap(pair), peak = peak_overlap(pair, memory);
    const double yield_force = virgin_force(y, pair);
    const double peak_force = virgin_force(peak, pair);
    const double recovered = // delta* - delta_p
        0.75 * peak_force /
        (effective_modulus_ * sqrt(pair.reduced_radius * peak));
    const double work =
        0.4 * yield_force * y + 0.5 * (yield_force + peak_force) * (peak - y);
    return {0.4 * force * max(0.0, overlap - (peak - recovered)),
            work - 0.4 * peak_force * recovered};
  }
  /// Nothing is lost as grains begin to touch or part.
  double lost_at_touch(const PairShape<double> &,
                       const NormalMemory<double> &) const
  {
    return 0;
  }
  double lost_at_tear(const PairShape<double> &,
                      const NormalMemory<double> &) const
  {
    return 0;
  }

private:
  double peak_overlap(const PairShape<double> &pair,
                      const NormalMemory<double> &memory) const
  {
    return max(memory.largest_overlap, yield_overlap(pair));
  }

  double effective_modulus_; // E*
  double plastic_slope_;     // pi p_y
  double yield_ratio_;       // delta_y / R*
  double offset_;            // of the line from the origin, over R*^2
};
} // namespace tamp::dem

#endif
