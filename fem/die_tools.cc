// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_tools.h>
#include <fem/tool_profiles.h>
#include <fem/tool_surface.h>

namespace tamp::fem
{
namespace
{
ToolSurface wall_of(const DieGeometry &die)
{
  const double rim = die.fill_height;
  if (die.shape == DieShape::square)
    return ToolSurface::extruded(
        rectangle_profile(die.side / 2, die.side / 2, die.corner_radius), rim);
  return ToolSurface::revolved(bore_profile(
      die.radius, rim, die.exit_taper_angle, die.exit_taper_length));
}
} // namespace

ToolSurfaces make_tools(const DieGeometry &geometry, const Mesh &mesh)
{
  geometry.check();
  if (geometry.shape == DieShape::file || !geometry.mesh_file.empty())
    return tools_of_mesh(mesh);
  const double edge =
      geometry.shape == DieShape::square ? geometry.side / 2 : geometry.radius;
  ToolSurfaces tools;
  tools[upper_punch] = ToolSurface::revolved(punch_profile(
      geometry.upper_face, edge, geometry.fill_height, /*upward=*/false));
  tools[lower_punch] = ToolSurface::revolved(
      punch_profile(geometry.lower_face, edge, 0, /*upward=*/true));
  tools[die_wall] = wall_of(geometry);
  if (geometry.shape == DieShape::ring)
    tools[core_rod] = ToolSurface::revolved(rod_profile(geometry.core_radius));
  return tools;
}
} // namespace tamp::fem
