// SPDX-License-Identifier: BSD-3-Clause
#include <fem/assembler.h>

#include <algorithm>

namespace tamp::fem
{
namespace
{
using Neighbours = std::vector<std::vector<unsigned>>;

/// The nodes that share a cell with each node, sorted.
Neighbours neighbours_of(const Mesh &mesh, const Share &cells)
{
  Neighbours result(mesh.nodes.size());
  const unsigned n = mesh.nodes_per_cell();
  for (std::size_t cell = cells.begin; cell < cells.end; ++cell) {
    const unsigned *nodes = mesh.nodes_of_cell(cell);
    for (unsigned a = 0; a < n; ++a)
      result[nodes[a]].insert(result[nodes[a]].end(), nodes, nodes + n);
  }
  for (auto &list : result) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return result;
}

SparseRows rows_of(const Neighbours &neighbours, unsigned components)
{
  SparseRows rows;
  rows.begin.push_back(0);
  for (const auto &list : neighbours)
    for (unsigned c = 0; c < components; ++c) {
      for (const unsigned node : list)
        for (unsigned d = 0; d < components; ++d)
          rows.column.push_back(static_cast<int>(components * node + d));
      rows.begin.push_back(static_cast<int>(rows.column.size()));
    }
  rows.value.assign(rows.column.size(), 0.);
  return rows;
}

/// Gradient of the displacement that moves a node by one along an axis, in the
/// axes (r, theta, z) if axisymmetric.
dealii::Tensor<2, 3> unit_gradient(const Mesh &mesh,
                                   const PointGeometry &geometry,
                                   unsigned node,
                                   unsigned axis)
{
  dealii::Tensor<2, 3> G;
  G[axis] = geometry.gradient[node];
  if (mesh.is_axisymmetric() && axis == 0)
    G[1][1] = geometry.value[node] / geometry.position[0];
  return G;
}

/// What the virtual gradient is multiplied with when the point moves with the
/// gradient L and its material feels the strain of `felt`.
dealii::Tensor<2, 3> stress_change(const Response &response,
                                   const dealii::Tensor<2, 3> &L,
                                   const dealii::Tensor<2, 3> &felt)
{
  const dealii::Tensor<2, 3> sigma(response.stress);
  const dealii::Tensor<2, 3> W = 0.5 * (L - dealii::transpose(L));
  const dealii::Tensor<2, 3> material(response.tangent *
                                      dealii::symmetrize(felt));
  return material + W * sigma - sigma * W + dealii::trace(L) * sigma -
         sigma * dealii::transpose(L);
}
} // namespace

Assembler::Assembler(const Mesh &mesh, const Share &cells)
    : mesh_(mesh), cells_(cells)
{
  const Neighbours neighbours = neighbours_of(mesh, cells);
  pattern_ = rows_of(neighbours, mesh.components());
  const unsigned n = mesh.nodes_per_cell();
  for (std::size_t cell = cells.begin; cell < cells.end; ++cell) {
    const unsigned *nodes = mesh.nodes_of_cell(cell);
    for (unsigned a = 0; a < n; ++a)
      for (unsigned b = 0; b < n; ++b) {
        const auto &list = neighbours[nodes[a]];
        const auto place = std::lower_bound(list.begin(), list.end(), nodes[b]);
        offsets_.push_back(
            static_cast<int>(mesh.components() * (place - list.begin())));
      }
  }
}

void Assembler::add_forces(std::size_t cell,
                           const CellPoints &points,
                           std::span<double> force) const
{
  const unsigned *nodes = mesh_.nodes_of_cell(cell);
  for (std::size_t q = 0; q < points.points.size(); ++q) {
    const PointGeometry &g = points.points[q];
    const auto &stress = points.responses[q].stress;
    for (unsigned a = 0; a < mesh_.nodes_per_cell(); ++a) {
      const dealii::Tensor<1, 3> traction = stress * g.gradient[a];
      for (unsigned c = 0; c < mesh_.components(); ++c)
        force[mesh_.dof(nodes[a], c)] += g.volume * traction[mesh_.axis(c)];
      if (mesh_.is_axisymmetric())
        force[mesh_.dof(nodes[a], 0)] +=
            g.volume * stress[1][1] * g.value[a] / g.position[0];
    }
  }
}

void Assembler::add_stiffness(std::size_t cell,
                              const CellPoints &points,
                              SparseRows &stiffness) const
{
  const unsigned n = mesh_.nodes_per_cell(), components = mesh_.components();
  const unsigned *nodes = mesh_.nodes_of_cell(cell);
  const int *offset = &offsets_[(cell - cells_.begin) * n * n];
  for (std::size_t q = 0; q < points.points.size(); ++q) {
    const PointGeometry &g = points.points[q];
    for (unsigned b = 0; b < n; ++b)
      for (unsigned d = 0; d < components; ++d) {
        const unsigned axis = mesh_.axis(d);
        const auto L = unit_gradient(mesh_, g, b, axis);
        auto felt = L;
        if (points.centre != nullptr) {
          const double more =
              dealii::trace(unit_gradient(mesh_, *points.centre, b, axis)) -
              dealii::trace(L);
          for (unsigned i = 0; i < 3; ++i)
            felt[i][i] += more / 3;
        }
        const auto change =
            g.volume * stress_change(points.responses[q], L, felt);
        for (unsigned a = 0; a < n; ++a)
          for (unsigned c = 0; c < components; ++c) {
            double entry = change[mesh_.axis(c)] * g.gradient[a];
            if (c == 0 && mesh_.is_axisymmetric())
              entry += change[1][1] * g.value[a] / g.position[0];
            const int row = static_cast<int>(mesh_.dof(nodes[a], c));
            stiffness.value[stiffness.begin[row] + offset[a * n + b] + d] +=
                entry;
          }
      }
  }
}
} // namespace tamp::fem
