// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_mdr_side_h
#define dem_laws_mdr_side_h

#include <dem/laws/sphere_on_flat.h>

namespace tamp::dem
{
/// What a contact remembers of one of its two sides. The law writes the first
/// number and reads the next three; grow_grains() writes all of them.
template <class V>
struct MdrMemory {
  static constexpr int size = 6;

  V largest;        ///< overlap ever, bulk part taken off [m]
  V bulk_overlap;   ///< delta_B when last seen [m]
  V bulk_stiffness; ///< kappa sum(A_c) / V of the grain; 0 while there is room
                    ///< around it [Pa/m]
  V seen;           ///< overlap when grow_grains() saw it last [m]
  V counted;        ///< overlap up to which the grain has grown, 0 before [m]
  V counted_push;   ///< force times distance of the flat from the centre of
                    ///< the grain then [J]

  /// From and to `size` numbers.
  static MdrMemory read(const V *more)
  {
    return {more[0], more[1], more[2], more[3], more[4], more[5]};
  }
  void write(V *more) const
  {
    const V numbers[size] = {
        largest, bulk_overlap, bulk_stiffness, seen, counted, counted_push};
    for (int k = 0; k < size; ++k)
      more[k] = numbers[k];
  }

  /// delta_B at another overlap in the same increment [m].
  V bulk_overlap_at(const V &overlap) const
  {
    return select(bulk_stiffness > V(0.0),
                  max(V(0.0), bulk_overlap + overlap - seen),
                  V(0.0));
  }
  /// The rest, at another overlap in the same increment, up to a peak [m].
  V local_overlap_at(const V &overlap, const V &peak) const
  {
    const V held = select(bulk_stiffness > V(0.0), bulk_overlap, V(0.0));
    return min(overlap - held, peak);
  }
};

/// One side of a contact: a grain against the rigid flat in the contact plane.
template <class V>
struct MdrSide {
  V overlap;        ///< of the grain with the flat, delta_i [m]
  V local_overlap;  ///< its part taken up at the contact [m]
  V bulk_overlap;   ///< delta_B, its part taken up by the whole grain [m]
  V area;           ///< A_c, geometric [m2]
  FlatPeak<V> peak; ///< largest overlap, bulk part taken off
  V force;          ///< N of this side, with N_bulk [N]
  V contact_radius; ///< [m]
};
} // namespace tamp::dem

#endif
