// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_near_pairs_h
#define dem_kernel_near_pairs_h

#include <dem/pair.h>

#include <cstddef>
#include <cstdint>

namespace tamp::dem
{
/// A pair and how it lies.
struct NearPair {
  Pair pair;
  double branch[3];   ///< from the first grain to the second [m]
  double overlap = 0; ///< R_i + R_j - |branch| [m]
};

/// What pairs are near: those with a gap below `gap`, by their nearest images.
struct PairSearch {
  double box[9]; ///< h, row by row [m]
  double gap;    ///< [m]
};

/// Grains by position in some order. Behind the last there is room for the
/// widest register.
struct OrderedGrains {
  static constexpr std::size_t room = 8;
  const double *x, *y, *z;    ///< fractional coordinates [-]
  const double *radius;       ///< [m]
  const std::uint32_t *grain; ///< which grain stands at a position
};

/// Positions of OrderedGrains: first, first + 1, ... last - 1.
struct Positions {
  std::size_t first, last;
};

/// The loops that look for near pairs. All instruction sets find the same pairs
/// and the same numbers, to the bit.
struct PairLoops {
  /// Writes those of `count` pairs that are near, in their order.
  /// @param place   three fractional coordinates of each grain [-]
  /// @param radius  of each grain [m]
  /// @param near    room for all `count` pairs
  /// @return how many are near
  using Filter = std::size_t (*)(const PairSearch &search,
                                 const Pair *pairs,
                                 std::size_t count,
                                 const double *place,
                                 const double *radius,
                                 NearPair *near);
  /// Writes the near pairs of each of `those` with the grains behind it in the
  /// first of `others`, and with all grains of the rest.
  /// @param pairs  room for all of them
  /// @return how many are near
  using Match = std::size_t (*)(const PairSearch &search,
                                const OrderedGrains &grains,
                                Positions those,
                                const Positions *others,
                                std::size_t count,
                                Pair *pairs);
  Filter filter;
  Match match;
};
} // namespace tamp::dem

#endif
