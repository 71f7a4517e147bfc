// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_mesh_tools_h
#define fem_mesh_tools_h

#include <fem/mesh.h>
#include <fem/tool_surface.h>

namespace tamp::fem
{
/// The tools around a mesh, read off their faces. In an axisymmetric mesh each
/// is a smooth curve through its nodes with sharp corners, see smooth_chain();
/// the wall and the core rod go on vertically, the
/// punches straight on. In space the wall is a circular cylinder or a rectangle
/// along the axes about the z axis, whose corners may be rounded by arcs of one
/// radius, the core rod a circular cylinder, and the punches are planes, all
/// within 1e-6 of their size. The bore ends at a rim at
/// the height of the upper punch's edge. Throws std::runtime_error naming the
/// tool and what was found if its shape is another, and if a tool other than
/// the core rod has no faces.
ToolSurfaces tools_of_mesh(const Mesh &mesh);
} // namespace tamp::fem

#endif
