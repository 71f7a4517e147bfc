// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_packing_file_h
#define coupling_packing_file_h

#include <coupling/whole_file.h>
#include <dem/unit_cell.h>

#include <filesystem>
#include <vector>

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
/// other [m]. Throws FileError.
void write_packing_text(const dem::UnitCell &cell,
                        const std::filesystem::path &file);

/// Reads either kind of file, told apart by content. From HDF5 the cell is
/// equal, to the last bit, to the one written. From text it has no contacts,
/// and material and contact model are left to the caller. Throws FileError if
/// the file cannot be read and std::invalid_argument, naming file and, of a
/// text, line, if it is no packing.
dem::UnitCell read_packing(const std::filesystem::path &file);

/// What became of the contacts of a stored packing.
enum class History {
  kept,     ///< the packing is as it was stored
  slipped,  ///< only friction is another: contacts slipped where they must
  forgotten ///< other grains or laws: contacts begin with the overlaps now
};

/// Puts a stored packing under the materials, one per species, and the contact
/// model of a run, brings it to equilibrium at the same box if these are not
/// its own, and lets the run begin there: without work and last motion. Throws
/// std::invalid_argument if it has more species than there are materials, and
/// std::runtime_error if it does not come to rest.
History adopt_packing(dem::UnitCell &cell,
                      const std::vector<dem::GrainMaterial> &materials,
                      const dem::ContactModel &contact);
} // namespace tamp::coupling

#endif
