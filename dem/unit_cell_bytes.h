// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_unit_cell_bytes_h
#define dem_unit_cell_bytes_h

#include <dem/unit_cell.h>

#include <span>
#include <vector>

namespace tamp::dem
{
/// Appends the whole cell to `bytes`, in the byte order of the machine.
void to_bytes(const UnitCell &cell, std::vector<char> &bytes);

/// The cell that to_bytes() wrote, equal to the last bit. Throws
/// std::runtime_error if the bytes are not a cell, or not all of one.
UnitCell from_bytes(std::span<const char> bytes);
} // namespace tamp::dem

#endif
