// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_mesh_import_h
#define fem_mesh_import_h

#include <fem/mesh.h>

#include <string>
#include <vector>

namespace tamp::fem
{
/// A mesh from a file, and what its user should know of it.
struct ImportedMesh {
  Mesh mesh;
  std::vector<std::string> remarks; ///< whole sentences; often none
};

/// Reads an ASCII file of gmsh (.msh 2.2 or 4.1, in metres). Quadrilaterals are
/// half a section of the compact, x = r and y = z in the file; the physical
/// curves of their boundary are die_wall, punch_top, punch_bottom, core (of a
/// ring) and axis (r = 0; needed unless there is a core). Hexahedra have z as
/// the pressing axis; their physical surfaces are die_wall, punch_top,
/// punch_bottom, core and, for a quarter, symmetry_x (x = 0) and symmetry_y
/// (y = 0). Every face of the boundary needs one of these names. Nodes on axis
/// and planes of symmetry are held there; a full mesh is held by the tools
/// alone. Nodes and cells are numbered from below.
///
/// Throws std::runtime_error that names the file, what is wrong, where, and
/// what to do.
ImportedMesh import_mesh(const std::string &file);
} // namespace tamp::fem

#endif
