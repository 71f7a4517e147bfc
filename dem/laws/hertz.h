// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_hertz_h
#define dem_laws_hertz_h

#include <dem/laws/pair_law.h>

namespace tamp::dem
{
/// Two elastic spheres without friction or adhesion.
/// Source: Hertz (1882); K. L. Johnson, Contact Mechanics (1985), ch. 4.
struct Hertz {
  static constexpr int more = 0; ///< numbers of its own in the memory

  double effective_modulus; ///< E* [Pa]

  /// N = 4/3 E* sqrt(R*) delta^(3/2), a = sqrt(R* delta).
  /// @param overlap  delta [m]; zero or negative gives zero force
  template <class V>
  NormalAnswer<V> operator()(const V &overlap,
                             const PairShape<V> &pair,
                             NormalMemory<V> &memory) const
  {
    const V delta = max(overlap, V(0.0));
    memory.largest_overlap = max(memory.largest_overlap, delta);
    const V a = sqrt(pair.reduced_radius * delta);
    return {V(4.0 / 3 * effective_modulus) * a * delta, a, V(0.0)};
  }

  /// dN/d delta for further loading [N/m].
  double loading_slope(double overlap,
                       const PairShape<double> &pair,
                       const NormalMemory<double> &) const
  {
    return 2 * effective_modulus *
           sqrt(pair.reduced_radius * max(overlap, 0.0));
  }
  /// dN/d delta of an unloading from the largest overlap [N/m].
  double steepest_slope(const PairShape<double> &pair,
                        const NormalMemory<double> &memory) const
  {
    return loading_slope(memory.largest_overlap, pair, memory);
  }
  bool is_plastic(const PairShape<double> &, const NormalMemory<double> &) const
  {
    return false;
  }

  /// U = 8/15 E* sqrt(R*) delta^(5/2).
  NormalEnergy energy(double overlap,
                      const PairShape<double> &pair,
                      NormalMemory<double> memory) const
  {
    return {0.4 * max(overlap, 0.0) * (*this)(overlap, pair, memory).force, 0};
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
};
} // namespace tamp::dem

#endif
