// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_grain_output_h
#define coupling_grain_output_h

#include <dem/unit_cell.h>

#include <filesystem>

namespace tamp::coupling
{
/// Writes a cell for ParaView: grains as vertices with `radius` [m] and `grain`
/// number, force-carrying contacts as lines (force chains) with `normal_force`
/// [N], `tangential_force` [N], `plastic` and `sliding`, the cell's edges as
/// lines. A line's values are zero on vertices and the other way round; `kind`
/// tells them apart: 0 grain, 1 contact, 2 edge. Contacts across the border are
/// drawn from the first grain to the image of the second.
/// @param rotation  from the cell's frame to that of the picture
/// Throws std::runtime_error naming the file if it cannot be written.
void write_grains(const dem::UnitCell &cell,
                  const dem::Matrix3 &rotation,
                  const std::filesystem::path &file);
} // namespace tamp::coupling

#endif
