// SPDX-License-Identifier: BSD-3-Clause
#include <fem/kinematics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tamp::fem
{
PointGeometry point_geometry(const Mesh &mesh,
                             const ShapeValues &shape,
                             const unsigned *nodes,
                             const NodePositions &positions)
{
  PointGeometry geometry;
  geometry.value = shape.value;
  dealii::Tensor<2, 3> jacobian; // d x_i / d xi_j
  if (mesh.is_axisymmetric())
    jacobian[1][1] = 1;
  for (unsigned a = 0; a < mesh.nodes_per_cell(); ++a) {
    const auto &x = positions[nodes[a]];
    geometry.position += shape.value[a] * x;
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = 0; j < 3; ++j)
        jacobian[i][j] += x[i] * shape.gradient[a][j];
  }
  geometry.volume = dealii::determinant(jacobian) * shape.weight;
  if (mesh.is_axisymmetric())
    geometry.volume *= 2 * std::numbers::pi * geometry.position[0];
  const dealii::Tensor<2, 3> inverse = dealii::invert(jacobian);
  for (unsigned a = 0; a < mesh.nodes_per_cell(); ++a)
    geometry.gradient[a] = shape.gradient[a] * inverse;
  return geometry;
}

std::vector<dealii::Tensor<1, 3>> point_positions(const Mesh &mesh)
{
  const Element element(mesh.is_axisymmetric());
  std::vector<dealii::Tensor<1, 3>> positions;
  for (std::size_t cell = 0; cell < mesh.number_of_cells(); ++cell)
    for (unsigned q = 0; q < mesh.points_per_cell(); ++q)
      positions.push_back(
          point_geometry(
              mesh, element.points[q], mesh.nodes_of_cell(cell), mesh.nodes)
              .position);
  return positions;
}

dealii::Tensor<2, 3> displacement_gradient(const Mesh &mesh,
                                           const PointGeometry &geometry,
                                           const unsigned *nodes,
                                           std::span<const double> displacement)
{
  dealii::Tensor<2, 3> result;
  for (unsigned a = 0; a < mesh.nodes_per_cell(); ++a)
    for (unsigned c = 0; c < mesh.components(); ++c)
      result[mesh.axis(c)] +=
          displacement[mesh.dof(nodes[a], c)] * geometry.gradient[a];
  if (mesh.is_axisymmetric())
    for (unsigned a = 0; a < mesh.nodes_per_cell(); ++a)
      result[1][1] += geometry.value[a] * displacement[mesh.dof(nodes[a], 0)] /
                      geometry.position[0];
  return result;
}

NodePositions moved(const Mesh &mesh,
                    const NodePositions &positions,
                    std::span<const double> displacement)
{
  NodePositions result = positions;
  for (std::size_t node = 0; node < result.size(); ++node)
    for (unsigned c = 0; c < mesh.components(); ++c)
      result[node][mesh.axis(c)] += displacement[mesh.dof(node, c)];
  return result;
}

Extent extent(const NodePositions &positions)
{
  Extent result;
  result.low = std::numeric_limits<double>::infinity();
  result.high = -result.low;
  for (const auto &x : positions) {
    result.low = std::min(result.low, x[2]);
    result.high = std::max(result.high, x[2]);
    result.radius = std::max(result.radius, std::hypot(x[0], x[1]));
  }
  return result;
}
} // namespace tamp::fem
