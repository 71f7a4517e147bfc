// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_contacts_h
#define dem_contacts_h

#include <dem/pair.h>
#include <dem/tensors.h>

namespace tamp::dem
{
/// What every contact remembers.
struct ContactMemory {
  Pair pair;
  Vector3 tangential_force = Vector3::Zero(); ///< on the first grain [N]
  double largest_overlap = 0;                 ///< ever [m]
  double contact_radius = 0;                  ///< at the last commit [m]
  bool operator==(const ContactMemory &) const = default;
};
} // namespace tamp::dem

#endif
