// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_order.h>
#include <fem/plane_section.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace tamp::fem
{
namespace
{
using Vector = dealii::Tensor<1, 3>;
constexpr double pi = std::numbers::pi;

/// Numbers nodes and cells along y, then x.
PlaneSection ordered(const PlaneSection &section)
{
  PlaneSection result;
  std::vector<unsigned> now(section.nodes.size());
  for (const unsigned node : order_from_below(section.nodes)) {
    now[node] = static_cast<unsigned>(result.nodes.size());
    result.nodes.push_back(section.nodes[node]);
  }
  std::vector<Vector> centres(section.number_of_cells());
  for (unsigned i = 0; i < section.cells.size(); ++i)
    centres[i / 4] += section.nodes[section.cells[i]] / 4.;
  for (const unsigned cell : order_from_below(centres))
    for (unsigned v = 0; v < 4; ++v)
      result.cells.push_back(now[section.cells[4 * cell + v]]);
  return result;
}

/// Place on the outline of the quarter at a share of its length, from the x
/// axis to the y axis.
Vector outline(double half_side, double corner_radius, double share)
{
  const double straight = half_side - corner_radius;
  const double half = straight + corner_radius * pi / 4;
  const bool first = share <= 0.5;
  const double length = (first ? share : 1 - share) * 2 * half;
  Vector place;
  if (length <= straight) {
    place[0] = half_side;
    place[1] = length;
  } else {
    const double angle =
        corner_radius > 0 ? (length - straight) / corner_radius : 0;
    place[0] = straight + corner_radius * std::cos(angle);
    place[1] = straight + corner_radius * std::sin(angle);
  }
  if (!first)
    std::swap(place[0], place[1]);
  return place;
}

/// A square block of `block` elements a side within `rings` rings.
class RingedBlock
{
public:
  RingedBlock(unsigned block, unsigned rings) : block_(block), rings_(rings) {}

  /// Node of the block.
  unsigned inner(unsigned i, unsigned j) const { return j * (block_ + 1) + i; }

  /// Node `along` the outline, from the x axis, of a ring; ring 0 is the rim of
  /// the block.
  unsigned outer(unsigned ring, unsigned along) const
  {
    if (ring == 0)
      return along <= block_ ? inner(block_, along)
                             : inner(2 * block_ - along, block_);
    return (block_ + 1) * (block_ + 1) + (ring - 1) * (2 * block_ + 1) + along;
  }

  unsigned number_of_nodes() const { return outer(rings_ + 1, 0); }

  std::vector<unsigned> cells() const
  {
    std::vector<unsigned> cells;
    const auto add = [&](unsigned a, unsigned b, unsigned c, unsigned d) {
      cells.insert(cells.end(), {a, b, c, d});
    };
    for (unsigned j = 0; j < block_; ++j)
      for (unsigned i = 0; i < block_; ++i)
        add(inner(i, j), inner(i + 1, j), inner(i, j + 1), inner(i + 1, j + 1));
    for (unsigned ring = 0; ring < rings_; ++ring)
      for (unsigned k = 0; k < 2 * block_; ++k)
        add(outer(ring, k),
            outer(ring + 1, k),
            outer(ring, k + 1),
            outer(ring + 1, k + 1));
    return cells;
  }

private:
  unsigned block_, rings_;
};

/// Neighbours of every node along the cells' edges.
std::vector<std::set<unsigned>> neighbours(const PlaneSection &section)
{
  std::vector<std::set<unsigned>> result(section.nodes.size());
  constexpr unsigned edges[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
  for (unsigned cell = 0; cell < section.number_of_cells(); ++cell)
    for (const auto &edge : edges) {
      const unsigned a = section.cells[4 * cell + edge[0]];
      const unsigned b = section.cells[4 * cell + edge[1]];
      result[a].insert(b);
      result[b].insert(a);
    }
  return result;
}

/// Moves the nodes that are not fixed to the mean of their neighbours, those
/// beyond the planes of symmetry included, by over-relaxation.
void relax(PlaneSection &section,
           const std::vector<bool> &fixed,
           unsigned elements)
{
  const auto around = neighbours(section);
  const double factor = 2 / (1 + std::sin(pi / (2 * elements + 2)));
  double extent = 0, change = 1;
  for (const Vector &node : section.nodes)
    extent = std::max(extent, node.norm());
  for (unsigned sweep = 0; sweep < 10000 && change > 1e-14 * extent; ++sweep) {
    change = 0;
    for (unsigned n = 0; n < section.nodes.size(); ++n) {
      Vector &node = section.nodes[n];
      if (fixed[n])
        continue;
      Vector sum;
      double weight = 0;
      for (const unsigned other : around[n]) {
        const Vector &place = section.nodes[other];
        const bool twice =
            (node[0] == 0 && place[0] > 0) || (node[1] == 0 && place[1] > 0);
        weight += twice ? 2 : 1;
        sum += (twice ? 2 : 1) * place;
      }
      Vector move = factor * (sum / weight - node);
      for (unsigned axis = 0; axis < 2; ++axis)
        if (node[axis] == 0)
          move[axis] = 0;
      node += move;
      change = std::max(change, move.norm());
    }
  }
}
} // namespace

PlaneSection radial_section(const std::vector<double> &radii)
{
  PlaneSection section;
  section.nodes_per_cell = 2;
  for (unsigned i = 0; i < radii.size(); ++i) {
    section.nodes.push_back(Vector({radii[i], 0, 0}));
    if (i > 0)
      section.cells.insert(section.cells.end(), {i - 1, i});
  }
  return section;
}

PlaneSection
rounded_square(double half_side, double corner_radius, unsigned elements)
{
  const double size = half_side / elements;
  const bool brick = elements == 1 || corner_radius <= size;
  const double half_outline = half_side - (1 - pi / 4) * corner_radius;
  const unsigned block =
      brick ? elements
            : std::clamp(static_cast<unsigned>(half_outline / size + 0.5),
                         1u,
                         elements - 1);
  const RingedBlock grid(block, elements - block);
  PlaneSection section;
  section.cells = grid.cells();
  section.nodes.resize(grid.number_of_nodes());
  std::vector<bool> fixed(section.nodes.size(), false);
  for (unsigned j = 0; j <= block; ++j)
    for (unsigned i = 0; i <= block; ++i)
      section.nodes[grid.inner(i, j)] =
          Vector({half_side * i / elements, half_side * j / elements, 0});
  for (unsigned k = 0; k <= 2 * block; ++k) {
    const Vector rim = section.nodes[grid.outer(0, k)];
    const Vector wall = outline(half_side, corner_radius, k / (2. * block));
    const unsigned rings = elements - block;
    for (unsigned ring = 1; ring <= rings; ++ring)
      section.nodes[grid.outer(ring, k)] =
          rim + (static_cast<double>(ring) / rings) * (wall - rim);
    section.nodes[grid.outer(rings, k)] = wall;
    fixed[grid.outer(rings, k)] = true;
  }
  fixed[grid.inner(0, 0)] = true;
  if (corner_radius > 0)
    relax(section, fixed, elements);
  return ordered(section);
}

PlaneSection ring_section(const std::vector<double> &radii)
{
  const double from = radii.front(), to = radii.back();
  const auto count = static_cast<unsigned>(radii.size());
  const double around = pi / 4 * (from + to) * (count - 1) / (to - from);
  const unsigned sectors = std::max(3u, static_cast<unsigned>(around + 0.5));
  PlaneSection section;
  for (unsigned k = 0; k <= sectors; ++k)
    for (unsigned i = 0; i < count; ++i) {
      const Vector unit = outline(1, 1, static_cast<double>(k) / sectors);
      section.nodes.push_back(radii[i] * unit);
      if (k > 0 && i > 0) {
        const unsigned last = k * count + i, below = last - count;
        section.cells.insert(section.cells.end(),
                             {below - 1, below, last - 1, last});
      }
    }
  return ordered(section);
}

PlaneSection mirrored(const PlaneSection &quarter)
{
  PlaneSection whole = quarter;
  for (unsigned axis = 0; axis < 2; ++axis) {
    const PlaneSection part = whole;
    std::vector<unsigned> image(part.nodes.size());
    for (unsigned n = 0; n < part.nodes.size(); ++n) {
      image[n] = n;
      if (part.nodes[n][axis] == 0)
        continue;
      image[n] = static_cast<unsigned>(whole.nodes.size());
      whole.nodes.push_back(part.nodes[n]);
      whole.nodes.back()[axis] *= -1;
    }
    // Swapped neighbours keep the area positive.
    for (unsigned i = 0; i < part.cells.size(); ++i)
      whole.cells.push_back(image[part.cells[i ^ 1]]);
  }
  return ordered(whole);
}
} // namespace tamp::fem
