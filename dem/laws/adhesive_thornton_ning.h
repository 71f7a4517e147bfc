// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_adhesive_thornton_ning_h
#define dem_laws_adhesive_thornton_ning_h

#include <dem/laws/adhesive_yield.h>

namespace tamp::dem
{
/// Spheres that adhere and yield: a virgin curve (adhesive_yield.h), and JKR's
/// law (jkr.h) with the radius R_p* and the overlap delta - delta_p for
/// unloading and reloading.
///
/// Grains that touch part at delta_p - 3/4 (pi^2 Gamma^2 R_p*/E*^2)^(1/3). They
/// touch again where the surfaces meet that remained, above delta_p, or at any
/// overlap that is larger than ever before, as in Thornton & Ning without
/// adhesion. Both set free a positive energy; the second matters only for
/// contacts that adhesion alone makes yield, where delta_p may exceed delta*.
/// Grains that are too fine or too soft for the law gain energy, see check().
/// Source: Thornton & Ning (1998), Powder Technol. 99:154.
class AdhesiveThorntonNing
{
public:
  static constexpr int more = 0; ///< numbers of its own in the memory

  /// @param effective_modulus  E* [Pa]
  /// @param limiting_pressure  p_y [Pa]; infinity gives JKR's law
  /// @param work_of_adhesion   Gamma, of the interface (twice the surface
  ///                           energy of equal solids) [J/m2]; zero gives
  ///                           Thornton & Ning's law
  AdhesiveThorntonNing(double effective_modulus,
                       double limiting_pressure,
                       double work_of_adhesion)
      : effective_modulus_(effective_modulus),
        elastic_(effective_modulus, work_of_adhesion),
        yield_(effective_modulus, limiting_pressure, elastic_)
  {
  }

  /// Throws std::invalid_argument if p_y is below
  /// AdhesiveYield::least_pressure() for this R* [m].
  void check(double radius) const { yield_.check(radius); }

  /// Force and contact radius at an overlap.
  template <class V>
  NormalAnswer<V> operator()(const V &overlap,
                             const PairShape<V> &pair,
                             NormalMemory<V> &memory) const
  {
    const V none(0.0), before = memory.largest_overlap;
    memory.largest_overlap = max(before, overlap);
    const Dent<V> left = yield_.dent(memory.largest_overlap, pair);
    const V over = left.over(overlap);
    const V s = elastic_.root(over, left.radius, left.root_scale);
    const V grip = select(memory.contact_radius > none,
                          elastic_.hold(max(none, none - over), left.radius),
                          max(over, overlap - before));
    return {select(grip > none, elastic_.force(s, left.radius), none),
            select(grip > none, s * s, none),
            select(grip > none, elastic_.pull_off(left.radius), none)};
  }

  /// dN/d delta for further loading [N/m]; 0 where the grains do not touch.
  double loading_slope(double overlap,
                       const PairShape<double> &pair,
                       NormalMemory<double> memory) const
  {
    const bool virgin = overlap >= memory.largest_overlap;
    const double a = (*this)(overlap, pair, memory).contact_radius;
    const Dent<double> left = yield_.dent(memory.largest_overlap, pair);
    if (virgin && a > 0 && left.peak_root > left.yield_root)
      return yield_.virgin_slope(left, pair.reduced_radius);
    return elastic_.slope(a, left.radius);
  }
  /// A bound on dN/d delta up to the largest overlap: 2 E* a there [N/m].
  double steepest_slope(const PairShape<double> &pair,
                        const NormalMemory<double> &memory) const
  {
    const Dent<double> left = yield_.dent(memory.largest_overlap, pair);
    const double s = elastic_.root(
        left.over(memory.largest_overlap), left.radius, left.root_scale);
    return 2 * effective_modulus_ * s * s;
  }
  /// Whether the contact has yielded.
  bool is_plastic(const PairShape<double> &pair,
                  const NormalMemory<double> &memory) const
  {
    const Dent<double> left = yield_.dent(memory.largest_overlap, pair);
    return memory.largest_overlap > 0 && left.peak_root > left.yield_root;
  }

  /// What Jkr::stored of the dented pair holds, and what yielding took.
  NormalEnergy energy(double overlap,
                      const PairShape<double> &pair,
                      NormalMemory<double> memory) const
  {
    const double a = (*this)(overlap, pair, memory).contact_radius;
    const Dent<double> left = yield_.dent(memory.largest_overlap, pair);
    return {elastic_.stored(a, left.radius),
            memory.largest_overlap > 0 ? yield_.lost(left, pair.reduced_radius)
                                       : 0};
  }
  /// Energy that grains lose as they begin to touch [J].
  /// @param memory  as it was before they touched
  double lost_at_touch(const PairShape<double> &pair,
                       const NormalMemory<double> &memory) const
  {
    const Dent<double> left = yield_.dent(memory.largest_overlap, pair);
    const double over = min(0.0, left.over(memory.largest_overlap));
    const double s = elastic_.root(over, left.radius, left.root_scale);
    const double first =
        memory.largest_overlap > 0 ? 0 : yield_.lost(left, pair.reduced_radius);
    return -elastic_.stored(s * s, left.radius) - first;
  }
  /// Energy that grains lose as they tear off [J].
  double lost_at_tear(const PairShape<double> &pair,
                      const NormalMemory<double> &memory) const
  {
    PairShape<double> dented = pair;
    dented.reduced_radius = yield_.dent(memory.largest_overlap, pair).radius;
    return elastic_.lost_at_tear(dented, memory);
  }

private:
  double effective_modulus_; // E*
  Jkr elastic_;
  AdhesiveYield yield_;
};
} // namespace tamp::dem

#endif
