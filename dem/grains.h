// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_grains_h
#define dem_grains_h

#include <vector>

namespace tamp::dem
{
/// One grain as the sweep sees it: a record of three cache lines that is
/// loaded in whole rows. `motion` is relative to the affine field: the
/// increment of displacement and of rotation times radius since the contact
/// memory was written (or, in dynamics, during a time step).
struct alignas(64) GrainRow {
  double place[3];       ///< fractional coordinates [-]
  double inverse_radius; ///< [1/m]
  double unused[4];
  double motion[8]; ///< displacement [m], 0, radius x rotation [m], 0
  double force[8];  ///< force [N], 0, torque / radius [N], 0
};
static_assert(sizeof(GrainRow) == 192);

using GrainRows = std::vector<GrainRow>;
} // namespace tamp::dem

#endif
