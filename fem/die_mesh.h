// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_die_mesh_h
#define fem_die_mesh_h

#include <fem/die_geometry.h>
#include <fem/mesh_import.h>

namespace tamp::fem
{
/// The mesh of the powder in a die: built in, read from a .msh file, or made by
/// gmsh from a .geo file. Throws what build_mesh(), import_mesh() and
/// import_geometry() throw.
ImportedMesh die_mesh(const DieGeometry &geometry);
} // namespace tamp::fem

#endif
