// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_field_output_h
#define fem_field_output_h

#include <fem/die_mesh_data.h>
#include <fem/die_model.h>
#include <fem/equilibrium.h>

#include <filesystem>
#include <vector>

namespace tamp::fem
{
/// Writes a VTU file (compressed binary): each cell as four quadrilaterals, one
/// per material point. Stresses and pressure are compression positive [Pa],
/// displacement [m]; x = r, y = z. Written under another name and renamed.
/// Throws std::runtime_error naming the file if it cannot be written.
void write_compact(const std::filesystem::path &file,
                   const DieMesh::Data &mesh,
                   const CompactState &state,
                   const std::vector<PointField> &extra);
} // namespace tamp::fem

#endif
