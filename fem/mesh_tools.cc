// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_tools.h>
#include <fem/smooth_chain.h>
#include <fem/tool_profiles.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

namespace tamp::fem
{
namespace
{
using Point = Profile::Point;
using Chain = std::vector<Point>;
using Vector = dealii::Tensor<1, 3>;

constexpr double tolerance = 1e-6; ///< of a tool's size [-]

template <class... Parts>
[[noreturn]] void complain(Tool tool, const Parts &...parts)
{
  std::ostringstream message;
  message << "mesh: " << tool_names[tool];
  (message << ... << parts);
  throw std::runtime_error(message.str());
}

Point meridian(const Vector &node)
{
  return Point({node[0], node[2]});
}

/// Nodes along the edges of a tool, from one end to the other.
Chain chain_of(const Mesh &mesh, Tool tool)
{
  const auto &faces = mesh.tools[tool].faces;
  std::map<unsigned, std::vector<unsigned>> neighbours;
  for (std::size_t i = 0; i + 1 < faces.size(); i += 2) {
    neighbours[faces[i]].push_back(faces[i + 1]);
    neighbours[faces[i + 1]].push_back(faces[i]);
  }
  unsigned ends = 0, node = 0, before = 0;
  for (const auto &[number, others] : neighbours) {
    if (others.size() > 2)
      complain(tool, " branches; expected one line of edges");
    if (others.size() == 1 && ends++ == 0)
      node = before = number;
  }
  Chain chain;
  if (ends == 2)
    while (true) {
      chain.push_back(meridian(mesh.nodes[node]));
      const auto &others = neighbours[node];
      const auto next = std::find_if(
          others.begin(), others.end(), [&](auto n) { return n != before; });
      if (next == others.end())
        break;
      before = node;
      node = *next;
    }
  if (ends != 2 || chain.size() != neighbours.size())
    complain(tool, " is not one line of edges from end to end");
  return chain;
}

/// The chain of a wall or rod, from below upwards.
Chain upward_chain(const Mesh &mesh, Tool tool)
{
  Chain chain = chain_of(mesh, tool);
  if (chain.front()[1] > chain.back()[1])
    std::reverse(chain.begin(), chain.end());
  return chain;
}

/// The chain of a punch, from the axis outwards.
Chain outward_chain(const Mesh &mesh, Tool tool)
{
  Chain chain = chain_of(mesh, tool);
  if (chain.front()[0] > chain.back()[0])
    std::reverse(chain.begin(), chain.end());
  return chain;
}

/// A smooth profile through these nodes.
ToolSurface turned(const Chain &chain, Tool tool)
{
  try {
    return ToolSurface::revolved(smooth_chain(chain));
  } catch (const std::invalid_argument &error) {
    complain(tool, ": ", error.what());
  }
}

ToolSurface turned_punch(Chain chain, Tool tool)
{
  // A face that reaches the axis is seen on its other side, too.
  if (std::abs(chain.front()[0]) <= tolerance * chain.back()[0]) {
    chain.front()[0] = 0;
    Chain whole;
    for (std::size_t i = chain.size() - 1; i > 0; --i)
      whole.push_back(Point({-chain[i][0], chain[i][1]}));
    whole.insert(whole.end(), chain.begin(), chain.end());
    chain = whole;
  }
  if (tool == upper_punch)
    std::reverse(chain.begin(), chain.end());
  return turned(chain, tool);
}

ToolSurface turned_wall(Chain chain, double rim)
{
  const Point bottom = chain.front();
  const double size = bottom[0];
  chain.insert(chain.begin(), Point({bottom[0], bottom[1] - size}));
  if (chain.back()[1] < rim - tolerance * size)
    chain.push_back(Point({chain.back()[0], rim}));
  chain.push_back(Point({chain.back()[0] + size, chain.back()[1]}));
  return turned(chain, die_wall);
}

ToolSurface turned_rod(Chain chain)
{
  const double size = chain.front()[0];
  chain.insert(chain.begin(), chain.front() - Point({0, size}));
  chain.push_back(chain.back() + Point({0, size}));
  std::reverse(chain.begin(), chain.end());
  return turned(chain, core_rod);
}

ToolSurfaces meridian_tools(const Mesh &mesh)
{
  const Chain top = outward_chain(mesh, upper_punch);
  ToolSurfaces tools;
  tools[upper_punch] = turned_punch(top, upper_punch);
  tools[lower_punch] =
      turned_punch(outward_chain(mesh, lower_punch), lower_punch);
  tools[die_wall] = turned_wall(upward_chain(mesh, die_wall), top.back()[1]);
  if (!mesh.tools[core_rod].faces.empty())
    tools[core_rod] = turned_rod(upward_chain(mesh, core_rod));
  return tools;
}

/// The largest distance of a tool's node from the z axis [m].
double largest_radius(const Mesh &mesh, Tool tool)
{
  double largest = 0;
  for (const unsigned node : mesh.tools[tool].nodes)
    largest =
        std::max(largest, std::hypot(mesh.nodes[node][0], mesh.nodes[node][1]));
  return largest;
}

/// Height of a punch that is a plane [m].
double plane_height(const Mesh &mesh, Tool tool)
{
  const double size = largest_radius(mesh, tool);
  const double height = mesh.nodes[mesh.tools[tool].nodes.front()][2];
  for (const unsigned node : mesh.tools[tool].nodes)
    if (std::abs(mesh.nodes[node][2] - height) > tolerance * size)
      complain(tool,
               " has nodes at z = ",
               height,
               " m and z = ",
               mesh.nodes[node][2],
               " m; expected a plane across the z axis");
  return height;
}

bool is_round(const Mesh &mesh, Tool tool, double radius)
{
  const auto &nodes = mesh.tools[tool].nodes;
  return std::all_of(nodes.begin(), nodes.end(), [&](unsigned node) {
    const double r = std::hypot(mesh.nodes[node][0], mesh.nodes[node][1]);
    return std::abs(r - radius) <= tolerance * radius;
  });
}

/// Nodes and centres of a tool's faces in space.
std::vector<Vector> places_on(const Mesh &mesh, Tool tool)
{
  std::vector<Vector> places;
  for (const unsigned node : mesh.tools[tool].nodes)
    places.push_back(mesh.nodes[node]);
  const auto &faces = mesh.tools[tool].faces;
  for (std::size_t i = 0; i + 3 < faces.size(); i += 4) {
    Vector sum;
    for (unsigned v = 0; v < 4; ++v)
      sum += mesh.nodes[faces[i + v]];
    places.push_back(sum / 4);
  }
  return places;
}

/// The walls of a rectangle whose corners are rounded, if all nodes lie on one;
/// the radius is that of the arc through the node farthest off the walls.
std::optional<ToolSurface>
rounded_wall(const Mesh &mesh, double half_x, double half_y, double rim)
{
  const double size = std::min(half_x, half_y);
  const auto &nodes = mesh.tools[die_wall].nodes;
  double farthest = tolerance * size, radius = 0;
  for (const unsigned node : nodes) {
    const double a = half_x - std::abs(mesh.nodes[node][0]);
    const double b = half_y - std::abs(mesh.nodes[node][1]);
    if (std::min(a, b) > farthest) {
      farthest = std::min(a, b);
      radius = a + b + std::sqrt(2 * a * b);
    }
  }
  if (!(radius > 0) || radius > (1 + tolerance) * size)
    return {};
  const ToolSurface wall = ToolSurface::extruded(
      rectangle_profile(half_x, half_y, std::min(radius, size)), rim);
  for (const unsigned node : nodes) {
    Vector place = mesh.nodes[node];
    place[2] =
        rim - size; // below the rim, which is nearer to nodes at its edge
    if (std::abs(wall.nearest(place).distance) > tolerance * size)
      return {};
  }
  return wall;
}

ToolSurface wall_in_space(const Mesh &mesh, double rim)
{
  // Corners alone could be those of a rectangle or lie on a circle.
  const auto places = places_on(mesh, die_wall);
  double half_x = 0, half_y = 0;
  for (const Vector &place : places) {
    half_x = std::max(half_x, std::abs(place[0]));
    half_y = std::max(half_y, std::abs(place[1]));
  }
  const double radius = largest_radius(mesh, die_wall);
  const auto off =
      std::find_if(places.begin(), places.end(), [&](const Vector &place) {
        return std::min(half_x - std::abs(place[0]),
                        half_y - std::abs(place[1])) > tolerance * radius;
      });
  if (off == places.end())
    return ToolSurface::extruded(rectangle_profile(half_x, half_y), rim);
  if (is_round(mesh, die_wall, radius))
    return ToolSurface::revolved(bore_profile(radius, rim));
  if (const auto rounded = rounded_wall(mesh, half_x, half_y, rim))
    return *rounded;
  complain(die_wall,
           " goes through x = ",
           (*off)[0],
           " m, y = ",
           (*off)[1],
           " m; expected a circular cylinder or an axis-parallel rectangle, "
           "also with rounded corners, about the z axis, here of radius ",
           radius,
           " m or of half sides ",
           half_x,
           " m and ",
           half_y,
           " m");
}

ToolSurface rod_in_space(const Mesh &mesh)
{
  const double radius = largest_radius(mesh, core_rod);
  if (!is_round(mesh, core_rod, radius))
    complain(core_rod,
             " has nodes closer to the z axis than ",
             radius,
             " m; expected a circular cylinder about it");
  return ToolSurface::revolved(rod_profile(radius));
}

ToolSurfaces tools_in_space(const Mesh &mesh)
{
  const double top = plane_height(mesh, upper_punch);
  const double bottom = plane_height(mesh, lower_punch);
  const double edge = largest_radius(mesh, upper_punch);
  ToolSurfaces tools;
  tools[upper_punch] =
      ToolSurface::revolved(punch_profile({}, edge, top, /*upward=*/false));
  tools[lower_punch] =
      ToolSurface::revolved(punch_profile({}, edge, bottom, /*upward=*/true));
  tools[die_wall] = wall_in_space(mesh, top);
  if (!mesh.tools[core_rod].nodes.empty())
    tools[core_rod] = rod_in_space(mesh);
  return tools;
}
} // namespace

ToolSurfaces tools_of_mesh(const Mesh &mesh)
{
  for (const Tool tool : {upper_punch, lower_punch, die_wall})
    if (mesh.tools[tool].nodes.empty() || mesh.tools[tool].faces.empty())
      complain(tool, " has no faces; expected some");
  return mesh.is_axisymmetric() ? meridian_tools(mesh) : tools_in_space(mesh);
}
} // namespace tamp::fem
