// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_packing_file_h
#define coupling_packing_file_h

#include <coupling/whole_file.h>
#include <dem/unit_cell.h>

#include <filesystem>

namespace tamp::coupling
{
/// Writes a whole cell, its contact history included, as a new HDF5 file:
/// datasets with names and units, a version, and a checksum in its first line.
/// The same cell gives the same bytes. Throws FileError if it cannot be written
/// or exists.
void write_packing(const dem::UnitCell &cell,
                   const std::filesystem::path &file);

/// Writes where the grains are as a new text file: `x y z r` [m] of a grain in
/// a line, places inside the box; before them a line `# L Lx Ly Lz` or, if the
/// edges are not along the axes, `# box` with the three edges one after the
/// other [m]. Grains that have grown are as they were. Throws FileError.
void write_packing_text(const dem::UnitCell &cell,
                        const std::filesystem::path &file);

/// Reads either kind of file, told apart by content. From HDF5 the cell is
/// equal, to the last bit, to the one written. From text it has no contacts,
/// and material and contact model are left to the caller. Throws FileError if
/// the file cannot be read and std::invalid_argument, naming file and, of a
/// text, line, if it is no packing.
dem::UnitCell read_packing(const std::filesystem::path &file);
} // namespace tamp::coupling

#endif
