// SPDX-License-Identifier: BSD-3-Clause
#include <fem/punch_area.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace tamp::fem
{
namespace
{
/// The area of a punch's faces shared out to all nodes of the mesh, so that the
/// integral of what is linear over an edge is exact [m2].
std::vector<double> node_areas(const Mesh &mesh, Tool punch)
{
  const auto &faces = mesh.tools[punch].faces;
  std::vector<double> areas(mesh.nodes.size(), 0.);
  for (std::size_t i = 0; i < faces.size(); i += mesh.nodes_per_face()) {
    const auto corner = [&](unsigned a) { return mesh.nodes[faces[i + a]]; };
    if (mesh.is_axisymmetric()) {
      const double inner = corner(0)[0], outer = corner(1)[0];
      const double third = std::numbers::pi / 3 * std::abs(outer - inner);
      areas[faces[i]] += third * (2 * inner + outer);
      areas[faces[i + 1]] += third * (inner + 2 * outer);
      continue;
    }
    const double area =
        0.5 * std::abs(dealii::cross_product_3d(corner(3) - corner(0),
                                                corner(2) - corner(1))[2]);
    for (unsigned a = 0; a < 4; ++a)
      areas[faces[i + a]] += 0.25 * area;
  }
  for (double &area : areas)
    area *= mesh.multiplicity();
  return areas;
}
} // namespace

double punch_area(const Mesh &mesh, Tool punch)
{
  const auto areas = node_areas(mesh, punch);
  return std::accumulate(areas.begin(), areas.end(), 0.);
}

double mean_height(const Mesh &mesh,
                   Tool punch,
                   const std::vector<dealii::Tensor<1, 3>> &positions)
{
  const auto areas = node_areas(mesh, punch);
  double area = 0, sum = 0;
  for (std::size_t node = 0; node < areas.size(); ++node) {
    area += areas[node];
    sum += areas[node] * positions[node][2];
  }
  return sum / area;
}

double edge_height(const Mesh &mesh,
                   Tool punch,
                   const std::vector<dealii::Tensor<1, 3>> &positions)
{
  const auto &wall = mesh.tools[die_wall].nodes;
  double edge = -std::numeric_limits<double>::infinity(), any = edge;
  for (const unsigned node : mesh.tools[punch].nodes) {
    any = std::max(any, positions[node][2]);
    if (std::binary_search(wall.begin(), wall.end(), node))
      edge = std::max(edge, positions[node][2]);
  }
  return std::isfinite(edge) ? edge : any;
}
} // namespace tamp::fem
