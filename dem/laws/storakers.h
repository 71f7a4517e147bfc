// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_storakers_h
#define dem_laws_storakers_h

#include <dem/laws/pair_law.h>

#include <numbers>

namespace tamp::dem
{
/// Spheres that yield from the first touch on, without an elastic start:
/// N = p_y pi a^2, a^2 = 2 c^2 R* delta, c^2 = 1.43. The limiting contact
/// pressure p_y is the mean pressure of a fully plastic contact, 3 sigma_0 with
/// the flow stress sigma_0 of the solid.
///
/// Unloading from delta*, N*, a* is elastic and keeps the flattened surfaces:
/// with z = (delta* - delta)/w, w = 2 p_y a*/E*,
/// N = N* 2/pi (arccos z - z sqrt(1 - z^2)), a = a* sqrt(1 - z^2). Reloading
/// retraces. Small contacts, delta* < w, are elastic in truth; w is then cut
/// down to delta*, so that grains part where they stop to overlap.
/// Source: Storakers, Biwa & Larsson (1997), Int. J. Solids Struct. 34:3061;
/// Storakers, Fleck & McMeeking (1999), J. Mech. Phys. Solids 47:785;
/// Mesarovic & Johnson (2000), J. Mech. Phys. Solids 48:2009.
class Storakers
{
public:
  static constexpr int more = 0; ///< numbers of its own in the memory

  /// @param effective_modulus  E* [Pa]
  /// @param limiting_pressure  p_y = 3 sigma_0 [Pa]
  Storakers(double effective_modulus, double limiting_pressure)
      : slope_(area * std::numbers::pi * limiting_pressure),
        recovery_(2 * limiting_pressure / effective_modulus)
  {
  }

  /// Force and contact radius at an overlap.
  /// @param overlap  delta [m]; zero or negative gives zero force
  template <class V>
  NormalAnswer<V> operator()(const V &overlap,
                             const PairShape<V> &pair,
                             NormalMemory<V> &memory) const
  {
    const V none(0.0), one(1.0);
    const V delta = max(overlap, none);
    const V peak = max(memory.largest_overlap, delta);
    memory.largest_overlap = peak;
    const V peak_radius = sqrt(V(area) * pair.reduced_radius * peak);
    const V w = min(V(recovery_) * peak_radius, peak);
    const V z = min(one, (peak - delta) / max(w, V(tiny)));
    const V root = sqrt(one - z * z);
    const V share = V(2 / std::numbers::pi) * (arc_cosine(z) - z * root);
    return {V(slope_) * pair.reduced_radius * peak * max(none, share),
            peak_radius * root,
            none};
  }

  /// dN/d delta for further loading: 2 c^2 pi p_y R* at the largest overlap,
  /// the slope of reloading below [N/m].
  double loading_slope(double overlap,
                       const PairShape<double> &pair,
                       NormalMemory<double> memory) const
  {
    if (overlap >= memory.largest_overlap)
      return slope_ * pair.reduced_radius;
    const double peak_radius = radius(pair, memory.largest_overlap);
    return steepest_slope(pair, memory) *
           (*this)(overlap, pair, memory).contact_radius / peak_radius;
  }
  /// dN/d delta of an unloading from the largest overlap, 4 N* / (pi w); this
  /// is 2 E* a* where w is not cut down [N/m].
  double steepest_slope(const PairShape<double> &pair,
                        const NormalMemory<double> &memory) const
  {
    const double peak = memory.largest_overlap;
    return 4 / std::numbers::pi * slope_ * pair.reduced_radius *
           max(1.0, peak / max(recovery_ * radius(pair, peak), tiny));
  }
  /// Whether the grains ever touched.
  bool is_plastic(const PairShape<double> &,
                  const NormalMemory<double> &memory) const
  {
    return memory.largest_overlap > 0;
  }

  /// What unloading gives back, 4/(3 pi) N* w from the largest overlap, and
  /// the rest of the work N* delta*/2 of the loading.
  NormalEnergy energy(double overlap,
                      const PairShape<double> &pair,
                      NormalMemory<double> memory) const
  {
    const double peak = max(memory.largest_overlap, max(overlap, 0.0));
    const double force = slope_ * pair.reduced_radius * peak;
    const double w = min(recovery_ * radius(pair, peak), peak);
    const double z = min(1.0, (peak - max(overlap, 0.0)) / max(w, tiny));
    const double root = sqrt(1 - z * z);
    const double share = root - z * std::acos(z) - root * root * root / 3;
    return {2 / std::numbers::pi * force * w * share,
            force * (0.5 * peak - 4 / (3 * std::numbers::pi) * w)};
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
  static constexpr double area = 2 * 1.43; // a^2 / (R* delta)

  static double radius(const PairShape<double> &pair, double overlap)
  {
    return sqrt(area * pair.reduced_radius * overlap);
  }

  double slope_;    // of the virgin curve, over R*
  double recovery_; // w / a*
};
} // namespace tamp::dem

#endif
