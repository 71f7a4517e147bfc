// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_grains_h
#define dem_grains_h

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tamp::dem
{
/// One grain as the sweep sees it, T is double or float: a record of whole
/// cache lines that is loaded in whole rows. In double precision these are two
/// lines, in single precision one.
template <class T>
struct alignas(64) GrainRow {
  /// Since the contact memory was written, beyond the affine field:
  /// displacement [m]; radius [m]; radius x rotation [m]; inverse mass [1/kg].
  T motion[8];
  T force[8]; ///< force [N], 0, torque / radius [N], 0
};
static_assert(sizeof(GrainRow<double>) == 128);

/// What the sweep knows a grain by: the bytes from the first row to its own.
template <class T>
std::uint32_t row_offset(std::size_t grain)
{
  assert(grain <= UINT32_MAX / sizeof(GrainRow<T>));
  return std::uint32_t(grain * sizeof(GrainRow<T>));
}
template <class T>
std::uint32_t grain_at(std::uint32_t offset)
{
  return offset / std::uint32_t(sizeof(GrainRow<T>));
}

template <class T>
using GrainRows = std::vector<GrainRow<T>>;
} // namespace tamp::dem

#endif
