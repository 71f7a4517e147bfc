// SPDX-License-Identifier: BSD-3-Clause
#include <fem/die_mesh.h>
#include <fem/die_mesh_data.h>
#include <fem/mesh_file.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Grid = dealii::Triangulation<2>;

ToolIds build_rectangle(const DieGeometry &geometry, Grid &grid)
{
  dealii::GridGenerator::subdivided_hyper_rectangle(
      grid,
      {geometry.radial_elements, geometry.axial_elements},
      dealii::Point<2>(0, 0),
      dealii::Point<2>(geometry.radius, geometry.fill_height),
      /*colorize=*/true);
  return {};
}

std::array<ReferencePoint, 4> reference_points()
{
  const dealii::FE_Q<2> element(1);
  const dealii::QGauss<2> gauss(2);
  std::array<ReferencePoint, 4> points;
  for (unsigned q = 0; q < 4; ++q) {
    points[q].weight = gauss.weight(q);
    for (unsigned a = 0; a < 4; ++a) {
      points[q].value[a] = element.shape_value(a, gauss.point(q));
      points[q].gradient[a] = element.shape_grad(a, gauss.point(q));
    }
  }
  return points;
}

/// Nodes of the boundary with this id, ordered along coordinate `axis`.
std::vector<unsigned> boundary_nodes(const Grid &grid, unsigned id, int axis)
{
  std::set<unsigned> nodes;
  for (const auto &cell : grid.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == id)
        for (unsigned v = 0; v < 2; ++v)
          nodes.insert(face->vertex_index(v));
  std::vector<unsigned> sorted(nodes.begin(), nodes.end());
  std::sort(sorted.begin(), sorted.end(), [&](unsigned a, unsigned b) {
    return grid.get_vertices()[a][axis] < grid.get_vertices()[b][axis];
  });
  return sorted;
}

/// The one value of coordinate `axis` on these nodes; throws if there are two.
double common_coordinate(const DieMesh::Data &data,
                         const std::vector<unsigned> &nodes,
                         unsigned axis,
                         double tolerance,
                         const std::string &what)
{
  if (nodes.empty())
    throw std::runtime_error(what + " has no edge");
  const double value = data.nodes[nodes.front()][axis];
  for (const unsigned node : nodes)
    if (std::abs(data.nodes[node][axis] - value) > tolerance)
      throw std::runtime_error(what + " is not at constant " +
                               (axis == 0 ? "r" : "z"));
  return value;
}

/// Throws unless every boundary edge belongs to a tool or the axis.
void check_edges(const Grid &grid, const ToolIds &ids, const std::string &name)
{
  for (const auto &cell : grid.active_cell_iterators())
    for (const auto &face : cell->face_iterators()) {
      const unsigned id = face->boundary_id();
      if (face->at_boundary() && id != ids.axis && id != ids.die_wall &&
          id != ids.punch_top && id != ids.punch_bottom)
        throw std::runtime_error(name +
                                 "has a boundary edge in none of 'axis', "
                                 "'die_wall', 'punch_top', 'punch_bottom'");
    }
}

void find_tools(const Grid &grid,
                const ToolIds &ids,
                const std::string &name,
                DieMesh::Data &data)
{
  check_edges(grid, ids, name);
  data.axis = boundary_nodes(grid, ids.axis, 1);
  data.wall = boundary_nodes(grid, ids.die_wall, 1);
  data.punch_bottom = boundary_nodes(grid, ids.punch_bottom, 0);
  data.punch_top = boundary_nodes(grid, ids.punch_top, 0);
  double largest = 0;
  for (const auto &node : data.nodes)
    largest = std::max(largest, node.norm());
  const double tolerance = 1e-9 * largest;
  const double axis =
      common_coordinate(data, data.axis, 0, tolerance, name + "axis");
  if (std::abs(axis) > tolerance)
    throw std::runtime_error(name + "axis is not at r = 0");
  for (const unsigned node : data.axis)
    data.nodes[node][0] = 0;
  data.radius =
      common_coordinate(data, data.wall, 0, tolerance, name + "die_wall");
  data.bottom = common_coordinate(
      data, data.punch_bottom, 1, tolerance, name + "punch_bottom");
  data.top =
      common_coordinate(data, data.punch_top, 1, tolerance, name + "punch_top");
  if (data.radius <= tolerance)
    throw std::runtime_error(name + "die_wall is not at positive r");
  if (data.top - data.bottom <= tolerance)
    throw std::runtime_error(name + "punch_top is not above punch_bottom");
}
} // namespace

DieMesh::DieMesh(const DieGeometry &geometry) : data_(std::make_unique<Data>())
{
  geometry.check();
  Grid grid;
  const bool built_in = geometry.mesh_file.empty();
  const ToolIds ids = built_in ? build_rectangle(geometry, grid)
                               : read_mesh_file(geometry.mesh_file, grid);
  const std::string name =
      built_in ? "" : "mesh file '" + geometry.mesh_file + "': ";
  for (const auto &vertex : grid.get_vertices())
    data_->nodes.push_back(vertex);
  find_tools(grid, ids, name, *data_);
  data_->reference = reference_points();
  for (const auto &cell : grid.active_cell_iterators()) {
    std::array<unsigned, 4> nodes;
    for (unsigned v = 0; v < 4; ++v)
      nodes[v] = cell->vertex_index(v);
    data_->cells.push_back(nodes);
    for (const ReferencePoint &reference : data_->reference) {
      dealii::Tensor<1, 2> position;
      for (unsigned v = 0; v < 4; ++v)
        position += reference.value[v] * data_->nodes[nodes[v]];
      data_->points.push_back(position);
    }
  }
}

DieMesh::~DieMesh() = default;

double DieMesh::radius() const { return data_->radius; }

double DieMesh::height() const { return data_->top - data_->bottom; }

std::size_t DieMesh::number_of_points() const
{
  return data_->number_of_points();
}

const std::vector<dealii::Tensor<1, 2>> &DieMesh::point_positions() const
{
  return data_->points;
}
} // namespace tamp::fem
