// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_mesh_defects_h
#define fem_mesh_defects_h

#include <fem/gmsh_file.h>
#include <fem/mesh.h>
#include <fem/mesh_faces.h>

#include <string>
#include <vector>

namespace tamp::fem
{
/// What is wrong with how the cells hang together, for people: nodes that
/// coincide but are not joined, cells that overlap, parts that do not touch.
/// Empty if nothing is.
std::string describe_defect(const Mesh &mesh);

/// What to say of boundary faces that belong to no tool, axis or plane of
/// symmetry: how many, where, under which other name, and if they come from
/// hanging nodes.
/// @param faces  at least one.
std::string describe_bare_faces(const GmshFile &file,
                                const std::vector<MeshFace> &faces);
} // namespace tamp::fem

#endif
