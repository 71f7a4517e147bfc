// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_mesh_file_h
#define fem_mesh_file_h

#include <array>
#include <string>

namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}

namespace tamp::fem
{
/// Boundary ids of the tools, as far as the mesh knows them.
struct ToolIds {
  unsigned axis = 0, die_wall = 1, punch_bottom = 2, punch_top = 3;
};

/// Reads an ASCII gmsh file (.msh 2.2 or 4.1) of quadrilaterals and returns the
/// boundary ids of the physical curves axis, die_wall, punch_bottom, punch_top.
/// Throws std::runtime_error naming the file and what is missing or wrong.
ToolIds read_mesh_file(const std::string &file,
                       dealii::Triangulation<2, 2> &triangulation);
} // namespace tamp::fem

#endif
