// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_mesh_template_h
#define fem_mesh_template_h

#include <fem/mesh_import.h>

#include <string>

namespace tamp::fem
{
/// True if the program gmsh can be found.
bool has_gmsh();

/// Meshes a geometry of gmsh (.geo) with the program gmsh, as a child process
/// that writes to a folder of its own among the temporary files, and imports
/// the mesh. Every caller runs its own gmsh; the same geometry gives the same
/// mesh.
/// @param parameters  values for names that the geometry declares in
///                    DefineConstant, "R = 6e-3, nr = 8"; lengths in m.
/// Throws std::invalid_argument naming the parameter that is not one or not
/// declared, std::runtime_error with gmsh's own words if it fails or is not
/// installed, and what import_mesh() throws.
ImportedMesh import_geometry(const std::string &file,
                             const std::string &parameters);
} // namespace tamp::fem

#endif
