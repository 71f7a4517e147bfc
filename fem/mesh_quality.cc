// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_faces.h>
#include <fem/mesh_quality.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

namespace tamp::fem
{
namespace
{
using Vector = dealii::Tensor<1, 3>;

/// A cell, a square (its directions are r and z) or a cube.
struct Corners {
  Corners(const Mesh &mesh, std::size_t cell)
      : directions(mesh.is_axisymmetric() ? 2 : 3), count(1u << directions)
  {
    for (unsigned v = 0; v < count; ++v)
      place[v] = mesh.nodes[mesh.nodes_of_cell(cell)[v]];
  }

  /// Determinant of a pair (r, z) or a triple of vectors.
  double determinant(const std::array<Vector, 3> &a) const
  {
    return directions == 2 ? a[0][0] * a[1][2] - a[0][2] * a[1][0]
                           : a[0] * dealii::cross_product_3d(a[1], a[2]);
  }

  unsigned directions, count;
  std::array<Vector, 8> place;
};

/// Rows of the Jacobian at xi in [0, 1]^d, and the position there.
std::array<Vector, 3> jacobian(const Corners &corners,
                               const std::array<double, 3> &xi,
                               Vector &position)
{
  std::array<Vector, 3> rows;
  position = Vector();
  for (unsigned v = 0; v < corners.count; ++v) {
    std::array<double, 3> value{1, 1, 1}, slope{};
    for (unsigned d = 0; d < corners.directions; ++d) {
      const bool upper = v >> d & 1;
      value[d] = upper ? xi[d] : 1 - xi[d];
      slope[d] = upper ? 1 : -1;
    }
    position += value[0] * value[1] * value[2] * corners.place[v];
    rows[0] += slope[0] * value[1] * value[2] * corners.place[v];
    rows[1] += value[0] * slope[1] * value[2] * corners.place[v];
    rows[2] += value[0] * value[1] * slope[2] * corners.place[v];
  }
  return rows;
}

/// The smallest scaled Jacobian of a cell; its edges widen the range of
/// lengths.
double
scaled_jacobian(const Corners &corners, double &shortest, double &longest)
{
  double worst = std::numeric_limits<double>::infinity();
  for (unsigned v = 0; v < corners.count; ++v) {
    std::array<Vector, 3> edges;
    double lengths = 1;
    for (unsigned d = 0; d < corners.directions; ++d) {
      const unsigned bit = 1u << d;
      edges[d] = corners.place[v | bit] - corners.place[v & ~bit];
      const double length = edges[d].norm();
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
      lengths *= length;
    }
    const double scaled =
        lengths > 0 ? corners.determinant(edges) / lengths : -1;
    worst = std::min(worst, scaled);
  }
  return worst;
}

double volume_of(const Corners &corners)
{
  const double offset = std::sqrt(1. / 12);
  double volume = 0;
  // Two Gauss points along each direction are exact: the determinant has
  // degree two at most along each direction, in a square one and r one.
  for (unsigned q = 0; q < corners.count; ++q) {
    std::array<double, 3> xi{};
    for (unsigned d = 0; d < corners.directions; ++d)
      xi[d] = 0.5 + (q >> d & 1 ? offset : -offset);
    Vector position;
    const auto rows = jacobian(corners, xi, position);
    const double around =
        corners.directions == 2 ? 2 * std::numbers::pi * position[0] : 1;
    volume += around * corners.determinant(rows) / corners.count;
  }
  return volume;
}
} // namespace

MeshQuality mesh_quality(const Mesh &mesh)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  MeshQuality quality;
  quality.nodes = mesh.nodes.size();
  quality.cells = mesh.number_of_cells();
  quality.scaled_jacobian = quality.shortest_edge = infinity;
  for (std::size_t cell = 0; cell < quality.cells; ++cell) {
    double shortest = infinity, longest = 0;
    const double scaled =
        scaled_jacobian(Corners(mesh, cell), shortest, longest);
    if (scaled < quality.scaled_jacobian) {
      quality.scaled_jacobian = scaled;
      quality.worst_place =
          centre_of(mesh, {mesh.nodes_of_cell(cell), mesh.nodes_per_cell()});
    }
    quality.aspect_ratio = std::max(quality.aspect_ratio, longest / shortest);
    quality.shortest_edge = std::min(quality.shortest_edge, shortest);
    quality.longest_edge = std::max(quality.longest_edge, longest);
  }
  return quality;
}

double mesh_volume(const Mesh &mesh)
{
  double volume = 0;
  for (std::size_t cell = 0; cell < mesh.number_of_cells(); ++cell)
    volume += volume_of(Corners(mesh, cell));
  return volume;
}

std::string describe(const MeshQuality &quality)
{
  std::ostringstream text;
  text.precision(3);
  text << quality.nodes << " nodes, " << quality.cells << " cells, edges from "
       << 1e3 * quality.shortest_edge << " to " << 1e3 * quality.longest_edge
       << " mm, smallest scaled Jacobian " << quality.scaled_jacobian
       << ", largest aspect ratio " << quality.aspect_ratio;
  return text.str();
}

std::string describe_place(const Mesh &mesh,
                           const dealii::Tensor<1, 3> &position)
{
  std::ostringstream text;
  text.precision(4);
  if (mesh.is_axisymmetric())
    text << "(r, z) = (";
  else
    text << "(x, y, z) = (";
  text << 1e3 * position[0] << ", ";
  if (!mesh.is_axisymmetric())
    text << 1e3 * position[1] << ", ";
  text << 1e3 * position[2] << ") mm";
  return text.str();
}
} // namespace tamp::fem
