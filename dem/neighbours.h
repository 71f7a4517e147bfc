// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_neighbours_h
#define dem_neighbours_h

#include <dem/kernel/instruction_set.h>
#include <dem/kernel/near_pairs.h>
#include <dem/pair.h>
#include <dem/periodic_box.h>
#include <dem/tensors.h>

#include <span>
#include <vector>

namespace tamp::dem
{
/// The outer of two neighbour lists: all pairs nearer than a wide skin when it
/// was built, sorted, and what tells how long it holds. The inner list, which
/// the sweep visits, is filtered from it.
struct Neighbours {
  std::vector<Pair> pairs;
  double skin = 0;               ///< largest gap of a pair [m]
  Matrix3 box = Matrix3::Zero(); ///< h when built [m]
  std::vector<Vector3> place;    ///< fractional coordinates when built
  bool operator==(const Neighbours &) const = default;
};

/// All pairs with a gap below `skin` [m], sorted. Throws std::runtime_error if
/// the box is too narrow for nearest images (narrower than two of the largest
/// pair's reaches). The list is the same on every instruction set.
Neighbours find_neighbours(const PeriodicBox &box,
                           std::span<const Vector3> place,
                           std::span<const double> radius,
                           double skin,
                           InstructionSet set = best_instruction_set());

/// Whether no pair outside the list can have a gap below `gap` [m].
bool still_hold(const Neighbours &neighbours,
                const PeriodicBox &box,
                std::span<const Vector3> place,
                double largest_radius,
                double gap);

/// The pairs of the list with a gap below `gap` [m] now, sorted, into `near`.
/// The same on every instruction set, to the bit. Asks for no memory if `near`
/// has room for as many pairs as the list has.
void find_near_pairs(const Neighbours &neighbours,
                     const PeriodicBox &box,
                     std::span<const Vector3> place,
                     std::span<const double> radius,
                     double gap,
                     std::vector<NearPair> &near,
                     InstructionSet set = best_instruction_set());
} // namespace tamp::dem

#endif
