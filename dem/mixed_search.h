// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_mixed_search_h
#define dem_mixed_search_h

#include <dem/mixed_control.h>

namespace tamp::dem
{
/// deform_mixed() by the map, with at least one stress prescribed.
MixedAnswer search_mixed(UnitCell &cell,
                         const MixedControl &control,
                         const Driving &driving);
} // namespace tamp::dem

#endif
