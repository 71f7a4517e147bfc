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
/// Nodes that coincide but are not joined, or cells that overlap, for people;
/// empty if there are none.
std::string describe_joints(const Mesh &mesh);

/// Parts of the mesh that share no faces, for people; empty if it is one.
std::string describe_islands(const Mesh &mesh);

/// What to say of boundary faces that belong to no tool, axis or plane of
/// symmetry: how many, where and under which other name, or that they come from
/// hanging nodes or a body apart.
/// @param faces  at least one.
std::string describe_bare_faces(const GmshFile &file,
                                const std::vector<MeshFace> &faces);
} // namespace tamp::fem

#endif
