// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_punch_area_h
#define fem_punch_area_h

#include <fem/mesh.h>

namespace tamp::fem
{
/// Area of the faces that a punch touches at the start, seen along the pressing
/// axis, of the whole compact [m2].
double punch_area(const Mesh &mesh, Tool punch);
} // namespace tamp::fem

#endif
