// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_grains_h
#define dem_grains_h

#include <vector>

namespace tamp::dem
{
/// One grain as the sweep sees it, T is double or float: a record of whole
/// cache lines that is loaded in whole rows. In double precision these are
/// three lines.
template <class T>
struct alignas(64) GrainRow {
  T moved[3];     ///< displacement since the pairs were listed, less that of
                  ///< the box [m]
  T radius;       ///< [m]
  T rotation[3];  ///< since the contact memory was written [rad]
  T inverse_mass; ///< [1/kg]
  /// Since the contact memory was written, relative to the affine field:
  /// displacement [m], 0, radius x rotation [m], 0.
  T motion[8];
  T force[8]; ///< force [N], 0, torque / radius [N], 0
};
static_assert(sizeof(GrainRow<double>) == 192);

template <class T>
using GrainRows = std::vector<GrainRow<T>>;
} // namespace tamp::dem

#endif
