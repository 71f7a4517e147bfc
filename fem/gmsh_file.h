// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_gmsh_file_h
#define fem_gmsh_file_h

#include <fem/mesh.h>
#include <fem/mesh_faces.h>

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace tamp::fem
{
/// What a gmsh file holds of the powder, not yet judged.
struct GmshFile {
  /// Nodes and cells; axisymmetric for quadrilaterals, full for hexahedra.
  Mesh mesh;
  std::size_t unused_nodes = 0;
  /// Physical names of the boundary's faces: curves of an axisymmetric file,
  /// else surfaces.
  std::map<unsigned, std::string> names;
  /// The physical number of every face of the boundary.
  std::map<FaceKey, unsigned> face_ids;
};

/// The error that a mesh file cannot be used.
std::runtime_error mesh_error(const std::string &file, const std::string &what);

/// Reads an ASCII file of gmsh (.msh 2.2 or 4.1) of quadrilaterals or of
/// hexahedra of first order. Throws std::runtime_error that names the file,
/// what is wrong and what to do.
GmshFile read_gmsh_file(const std::string &file);
} // namespace tamp::fem

#endif
