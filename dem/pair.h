// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_pair_h
#define dem_pair_h

#include <compare>
#include <cstdint>

namespace tamp::dem
{
/// Two grains, first < second.
struct Pair {
  std::uint32_t first, second;
  auto operator<=>(const Pair &) const = default;
};
} // namespace tamp::dem

#endif
