// SPDX-License-Identifier: BSD-3-Clause
#include <fem/assembler.h>

namespace tamp::fem
{
namespace
{
/// Gradient in the axes (r, theta, z) of the displacement that moves one node
/// by one along component c.
dealii::Tensor<2, 3>
unit_gradient(const PointGeometry &geometry, unsigned a, unsigned c)
{
  dealii::Tensor<2, 3> G;
  const unsigned row = c == 0 ? 0 : 2;
  G[row][0] = geometry.gradient[a][0];
  G[row][2] = geometry.gradient[a][1];
  if (c == 0)
    G[1][1] = geometry.value[a] / geometry.position[0];
  return G;
}

/// What the virtual gradient G is multiplied with when the point moves with the
/// gradient L.
dealii::Tensor<2, 3> stress_change(const Response &response,
                                   const dealii::Tensor<2, 3> &L)
{
  const dealii::Tensor<2, 3> sigma(response.stress);
  const dealii::Tensor<2, 3> W = 0.5 * (L - dealii::transpose(L));
  const dealii::Tensor<2, 3> material(response.tangent *
                                      dealii::symmetrize(L));
  return material + W * sigma - sigma * W + dealii::trace(L) * sigma -
         sigma * dealii::transpose(L);
}
} // namespace

SparseRows stiffness_pattern(const DieMesh::Data &mesh)
{
  std::vector<std::set<int>> columns(mesh.number_of_dofs());
  for (const auto &nodes : mesh.cells)
    for (const unsigned a : nodes)
      for (const unsigned b : nodes)
        for (int c = 0; c < 4; ++c)
          columns[2 * a + c / 2].insert(2 * static_cast<int>(b) + c % 2);
  return SparseRows(columns);
}

std::vector<double> internal_forces(const DieMesh::Data &mesh,
                                    const NodePositions &positions,
                                    std::span<const Response> responses)
{
  std::vector<double> force(mesh.number_of_dofs(), 0.);
  for (std::size_t point = 0; point < responses.size(); ++point) {
    const PointGeometry g = point_geometry(mesh, positions, point);
    const auto &s = responses[point].stress;
    const auto &nodes = mesh.cells[point / 4];
    for (unsigned a = 0; a < 4; ++a) {
      const auto &dN = g.gradient[a];
      const double hoop = g.value[a] / g.position[0];
      force[2 * nodes[a]] +=
          g.volume * (s[0][0] * dN[0] + s[0][2] * dN[1] + s[1][1] * hoop);
      force[2 * nodes[a] + 1] +=
          g.volume * (s[0][2] * dN[0] + s[2][2] * dN[1]);
    }
  }
  return force;
}

void assemble_stiffness(const DieMesh::Data &mesh,
                        const NodePositions &positions,
                        std::span<const Response> responses,
                        SparseRows &stiffness)
{
  std::fill(stiffness.value.begin(), stiffness.value.end(), 0.);
  for (std::size_t point = 0; point < responses.size(); ++point) {
    const PointGeometry geometry = point_geometry(mesh, positions, point);
    const auto &nodes = mesh.cells[point / 4];
    std::array<dealii::Tensor<2, 3>, 8> G;
    for (unsigned i = 0; i < 8; ++i)
      G[i] = unit_gradient(geometry, i / 2, i % 2);
    for (unsigned j = 0; j < 8; ++j) {
      const auto change = stress_change(responses[point], G[j]);
      const int column = 2 * nodes[j / 2] + j % 2;
      for (unsigned i = 0; i < 8; ++i)
        stiffness.at(2 * nodes[i / 2] + i % 2, column) +=
            geometry.volume * dealii::scalar_product(G[i], change);
    }
  }
}
} // namespace tamp::fem
