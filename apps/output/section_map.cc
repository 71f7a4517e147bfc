// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/section_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace tamp::apps
{
namespace
{
using Vector = dealii::Tensor<1, 3>;

// A place in a cell, each coordinate in [-1, 1].
using Place = std::array<double, 3>;

// Place in space of a place in a cell, by the cell's points at +-1/sqrt(3).
Vector in_space(const Vector *points, unsigned number, const Place &place)
{
  Vector sum;
  for (unsigned point = 0; point < number; ++point) {
    double weight = 1;
    for (unsigned axis = 0; (1u << axis) < number; ++axis) {
      const double share = 0.5 * (1 + std::sqrt(3.) * place[axis]);
      weight *= point & (1u << axis) ? share : 1 - share;
    }
    sum += weight * points[point];
  }
  return sum;
}

// The side of a cell that the section shows: the axis across it and which of
// its two ends; and the axes along it.
struct Side {
  unsigned across, end;
  std::array<unsigned, 2> along;
};

// Of a hexahedron, the side on the plane y = 0, x >= 0.
std::optional<Side> side_on_plane(const fem::Mesh &mesh, std::size_t cell)
{
  constexpr double level = 1e-9; // of the cell's extent
  const unsigned *nodes = mesh.nodes_of_cell(cell);
  const double extent = (mesh.nodes[nodes[7]] - mesh.nodes[nodes[0]]).norm();
  const auto on_plane = [&](unsigned node) {
    const Vector &place = mesh.nodes[nodes[node]];
    return std::abs(place[1]) <= level * extent && place[0] >= -level * extent;
  };
  for (unsigned across = 0; across < 3; ++across)
    for (unsigned end = 0; end < 2; ++end) {
      bool all = true;
      for (unsigned node = 0; node < 8; ++node)
        all = all && (((node >> across) & 1u) != end || on_plane(node));
      if (all)
        return Side{
            across, end, {across == 0 ? 1u : 0u, across == 2 ? 1u : 2u}};
    }
  return {};
}

// Of the points of all ranks.
std::vector<Vector> all_positions(const fem::DieModel &model)
{
  const auto own = model.point_positions();
  std::vector<Vector> positions;
  for (unsigned axis = 0; axis < 3; ++axis) {
    std::vector<double> component;
    for (const Vector &position : own)
      component.push_back(position[axis]);
    const auto all = model.whole(component);
    positions.resize(all.size());
    for (std::size_t point = 0; point < all.size(); ++point)
      positions[point][axis] = all[point];
  }
  return positions;
}

// A whole compact has cells on both sides of the plane: one is enough.
bool is_behind(const fem::Mesh &mesh, std::size_t cell)
{
  double lowest = 0, highest = 0;
  for (unsigned node = 0; node < mesh.nodes_per_cell(); ++node) {
    const double y = mesh.nodes[mesh.nodes_of_cell(cell)[node]][1];
    lowest = std::min(lowest, y);
    highest = std::max(highest, y);
  }
  return -lowest > highest;
}
} // namespace

std::vector<ValueQuadrilateral>
section_map(const fem::Mesh &mesh,
            const fem::DieModel &model,
            const std::function<double(const fem::Response &)> &value)
{
  const std::vector<Vector> positions = all_positions(model);
  std::vector<double> own;
  for (const fem::Response &response : model.responses())
    own.push_back(value(response));
  const std::vector<double> values = model.whole(own);
  const unsigned number = mesh.points_per_cell();
  std::vector<ValueQuadrilateral> map;
  for (std::size_t cell = 0; cell < mesh.number_of_cells(); ++cell) {
    std::optional<Side> side;
    if (mesh.is_axisymmetric())
      side = Side{2, 0, {0, 1}};
    else if (!is_behind(mesh, cell))
      side = side_on_plane(mesh, cell);
    if (!side)
      continue;
    const auto corner = [&](double a, double b) {
      Place place{};
      place[side->across] = side->end == 0 ? -1 : 1;
      place[side->along[0]] = a;
      place[side->along[1]] = b;
      const Vector x = in_space(&positions[cell * number], number, place);
      return std::array<double, 2>{x[0], x[2]};
    };
    for (unsigned part = 0; part < 4; ++part) {
      const double a = part % 2 == 0 ? -1 : 0, b = part / 2 == 0 ? -1 : 0;
      const std::size_t point = cell * number + (side->end << side->across) +
                                ((part % 2) << side->along[0]) +
                                ((part / 2) << side->along[1]);
      map.push_back({{corner(a, b),
                      corner(a + 1, b),
                      corner(a + 1, b + 1),
                      corner(a, b + 1)},
                     values[point]});
    }
  }
  return map;
}
} // namespace tamp::apps
