// SPDX-License-Identifier: BSD-3-Clause
#include <fem/kinematics.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tamp::fem
{
PointGeometry point_geometry(const DieMesh::Data &mesh,
                             const NodePositions &positions,
                             std::size_t point)
{
  const auto &nodes = mesh.cells[point / 4];
  const ReferencePoint &reference = mesh.reference[point % 4];
  PointGeometry geometry;
  geometry.value = reference.value;
  dealii::Tensor<2, 2> jacobian; // d x_i / d xi_j
  for (unsigned a = 0; a < 4; ++a) {
    const auto &x = positions[nodes[a]];
    geometry.position += reference.value[a] * x;
    jacobian += dealii::outer_product(x, reference.gradient[a]);
  }
  const double determinant = dealii::determinant(jacobian);
  geometry.volume = 2 * std::numbers::pi * geometry.position[0] * determinant *
                    reference.weight;
  const dealii::Tensor<2, 2> inverse = dealii::invert(jacobian);
  for (unsigned a = 0; a < 4; ++a)
    geometry.gradient[a] = reference.gradient[a] * inverse;
  return geometry;
}

NodePositions moved(const NodePositions &positions,
                    const Displacement &displacement)
{
  NodePositions result = positions;
  for (std::size_t node = 0; node < result.size(); ++node)
    for (unsigned c = 0; c < 2; ++c)
      result[node][c] += displacement[2 * node + c];
  return result;
}

void relative_deformations(const DieMesh::Data &mesh,
                           const NodePositions &committed,
                           const Displacement &increment,
                           std::vector<Deformation> &deformations)
{
  deformations.resize(mesh.number_of_points());
  for (std::size_t point = 0; point < deformations.size(); ++point) {
    const PointGeometry geometry = point_geometry(mesh, committed, point);
    const auto &nodes = mesh.cells[point / 4];
    dealii::Tensor<2, 3> F;
    F[0][0] = F[1][1] = F[2][2] = 1;
    for (unsigned a = 0; a < 4; ++a) {
      const double u_r = increment[2 * nodes[a]];
      const double u_z = increment[2 * nodes[a] + 1];
      F[0][0] += geometry.gradient[a][0] * u_r;
      F[0][2] += geometry.gradient[a][1] * u_r;
      F[1][1] += geometry.value[a] * u_r / geometry.position[0];
      F[2][0] += geometry.gradient[a][0] * u_z;
      F[2][2] += geometry.gradient[a][1] * u_z;
    }
    deformations[point].relative_F = F;
  }
}

double largest_strain(const std::vector<Deformation> &deformations)
{
  double largest = 0;
  for (const Deformation &deformation : deformations)
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = 0; j < 3; ++j)
        largest = std::max(
            largest, std::abs(deformation.relative_F[i][j] - (i == j)));
  return largest;
}
} // namespace tamp::fem
