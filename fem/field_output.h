// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_field_output_h
#define fem_field_output_h

#include <fem/die_model.h>
#include <fem/press.h>

#include <filesystem>
#include <vector>

namespace tamp::fem
{
/// Writes the accepted state as a VTU file (compressed binary): each cell in as
/// many parts as it has material points, quadrilaterals or hexahedra. Stresses
/// and pressures are compression positive [Pa], displacement and slip in m; an
/// axisymmetric compact lies in x = r, y = z. Written under another name and
/// renamed. Collective; the first rank writes. Throws std::runtime_error naming
/// the file if it cannot be written. @param extra  one value for each point of
/// this rank.
void write_compact(const std::filesystem::path &file,
                   const Press &press,
                   const std::vector<PointField> &extra);
} // namespace tamp::fem

#endif
