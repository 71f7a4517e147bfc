// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_faces.h>
#include <fem/mesh_order.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

namespace tamp::fem
{
namespace
{
using Positions = std::vector<dealii::Tensor<1, 3>>;

void sort_along(std::span<unsigned> indices,
                const Positions &positions,
                unsigned axis,
                double tolerance)
{
  const auto coordinate = [&](unsigned index) {
    return positions[index][axis];
  };
  std::stable_sort(indices.begin(), indices.end(), [&](unsigned a, unsigned b) {
    return coordinate(a) < coordinate(b);
  });
  if (axis == 0)
    return;
  for (std::size_t first = 0, last = 0; first < indices.size(); first = last) {
    for (last = first + 1; last < indices.size(); ++last)
      if (coordinate(indices[last]) - coordinate(indices[last - 1]) > tolerance)
        break;
    std::span<unsigned> layer = indices.subspan(first, last - first);
    std::sort(layer.begin(), layer.end());
    sort_along(layer, positions, axis - 1, tolerance);
  }
}
} // namespace

std::vector<unsigned>
order_from_below(const std::vector<dealii::Tensor<1, 3>> &positions)
{
  std::vector<unsigned> indices(positions.size());
  std::iota(indices.begin(), indices.end(), 0u);
  double extent = 0;
  for (const auto &position : positions)
    extent = std::max(extent, (position - positions.front()).norm());
  sort_along(indices, positions, 2, 1e-9 * extent);
  return indices;
}

void renumber_from_below(Mesh &mesh)
{
  const std::vector<unsigned> old_nodes = order_from_below(mesh.nodes);
  std::vector<unsigned> now(old_nodes.size());
  Positions nodes;
  for (unsigned i = 0; i < old_nodes.size(); ++i) {
    now[old_nodes[i]] = i;
    nodes.push_back(mesh.nodes[old_nodes[i]]);
  }
  mesh.nodes = std::move(nodes);
  const auto rename = [&](std::vector<unsigned> &numbers) {
    for (unsigned &number : numbers)
      number = now[number];
  };
  rename(mesh.cells);
  for (Mesh::Contact &tool : mesh.tools)
    rename(tool.faces);
  collect_nodes(mesh);
  for (Mesh::Held &held : mesh.held)
    held.node = now[held.node];
  std::sort(mesh.held.begin(), mesh.held.end(), [](auto a, auto b) {
    return std::pair(a.node, a.axis) < std::pair(b.node, b.axis);
  });

  Positions centres;
  for (std::size_t cell = 0; cell < mesh.number_of_cells(); ++cell)
    centres.push_back(
        centre_of(mesh, {mesh.nodes_of_cell(cell), mesh.nodes_per_cell()}));
  std::vector<unsigned> cells;
  for (const unsigned cell : order_from_below(centres))
    cells.insert(cells.end(),
                 mesh.nodes_of_cell(cell),
                 mesh.nodes_of_cell(cell) + mesh.nodes_per_cell());
  mesh.cells = std::move(cells);
}
} // namespace tamp::fem
