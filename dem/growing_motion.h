// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_growing_motion_h
#define dem_growing_motion_h

#include <dem/motion.h>

#include <memory>

namespace tamp::dem
{
/// start_motion(), for cells of any law: at the start, and then before every
/// advance that begins 1e-3 of strain or 500 time steps later, grains grow
/// where they do so, and limiting contact pressures that are adjusted follow
/// the density. Between, the motion is a plain one.
std::unique_ptr<Motion> start_growing_motion(UnitCell &cell,
                                             const Dynamics &settings,
                                             const Arithmetic &arithmetic);
} // namespace tamp::dem

#endif
