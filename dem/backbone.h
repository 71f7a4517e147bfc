// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_backbone_h
#define dem_backbone_h

#include <cstddef>
#include <vector>

namespace tamp::dem
{
class UnitCell;
struct ContactForce;

/// The part of a packing that can carry a load.
struct Backbone {
  std::size_t rattlers = 0; ///< grains that are not part of it
  std::size_t contacts = 0; ///< between grains of it
  /// 2 contacts / grains of the backbone; 0 if there are none [-].
  double coordination_number = 0;
};

/// Takes away, again and again, the grains that cannot be held by those left:
/// with friction, grains with fewer than two contacts; without, grains with
/// fewer than four.
/// @param contacts  contact_forces(cell)
Backbone find_backbone(const UnitCell &cell,
                       const std::vector<ContactForce> &contacts);
} // namespace tamp::dem

#endif
