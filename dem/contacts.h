// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_contacts_h
#define dem_contacts_h

#include <dem/tensors.h>

#include <compare>
#include <cstddef>
#include <cstdint>

namespace tamp::dem
{
/// Two grains, first < second.
struct Pair {
  std::uint32_t first, second;
  auto operator<=>(const Pair &) const = default;
};

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
