// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_mixed_servo_h
#define dem_mixed_servo_h

#include <dem/mixed_control.h>

namespace tamp::dem
{
/// deform_mixed() by dynamics, with at least one stress prescribed.
MixedAnswer servo_mixed(UnitCell &cell,
                        const MixedControl &control,
                        const Dynamics &settings,
                        const Arithmetic &arithmetic);
} // namespace tamp::dem

#endif
