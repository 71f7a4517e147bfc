// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/mesh_faces.h>
#include <fem/plane_section.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Vector = dealii::Tensor<1, 3>;

/// Appends `elements` equal steps up to `to`; the first element of the list is
/// there already.
void append_steps(std::vector<double> &places, double to, unsigned elements)
{
  const double from = places.back();
  const double step = (to - from) / elements;
  for (unsigned i = 1; i <= elements; ++i)
    places.push_back(from + i * step);
}

/// Places along the radius: equal steps between the breaks.
std::vector<double> radial_places(const DieGeometry &geometry)
{
  const double from =
      geometry.shape == DieShape::ring ? geometry.core_radius : 0;
  const double to = geometry.radius;
  const unsigned elements = geometry.radial_elements;
  std::vector<double> breaks;
  for (const PunchFace *face : {&geometry.lower_face, &geometry.upper_face})
    if ((face->kind == PunchFace::Kind::chamfer ||
         face->kind == PunchFace::Kind::bevel) &&
        to - face->width > from)
      breaks.push_back(to - face->width);
  std::sort(breaks.begin(), breaks.end());
  if (breaks.size() == 2 && breaks[1] - breaks[0] < 1e-9 * to)
    breaks.pop_back();
  if (breaks.size() >= elements)
    breaks.clear();

  std::vector<double> places{from};
  unsigned used = 0, left = static_cast<unsigned>(breaks.size());
  for (const double place : breaks) {
    const double share = (place - from) / (to - from);
    const unsigned until =
        std::clamp(static_cast<unsigned>(share * elements + 0.5),
                   used + 1,
                   elements - left);
    append_steps(places, place, until - used);
    used = until;
    --left;
  }
  append_steps(places, to, elements - used);
  return places;
}

PlaneSection section_of(const DieGeometry &geometry)
{
  if (geometry.section == Section::axisymmetric)
    return radial_section(radial_places(geometry));
  const bool square = geometry.shape == DieShape::square;
  const double half = square ? geometry.side / 2 : geometry.radius;
  const PlaneSection quarter =
      geometry.shape == DieShape::ring
          ? ring_section(radial_places(geometry))
          : rounded_square(half,
                           square ? geometry.corner_radius : half,
                           geometry.radial_elements);
  return geometry.section == Section::quarter ? quarter : mirrored(quarter);
}

/// Nodes of all slices; a column of them at every node of the section.
std::vector<Vector> place_nodes(const DieGeometry &geometry,
                                const PlaneSection &section)
{
  const std::size_t base = section.nodes.size();
  const unsigned layers = geometry.axial_elements;
  std::vector<Vector> nodes(base * (layers + 1));
  for (std::size_t i = 0; i < base; ++i) {
    double lower = 0, upper = geometry.fill_height;
    if (geometry.shape != DieShape::square) {
      const double r = std::min(section.nodes[i].norm(), geometry.radius);
      lower += geometry.lower_face.height(r, geometry.radius);
      upper -= geometry.upper_face.height(r, geometry.radius);
    }
    const double step = (upper - lower) / layers;
    for (unsigned layer = 0; layer <= layers; ++layer) {
      nodes[layer * base + i] = section.nodes[i];
      nodes[layer * base + i][2] = lower + layer * step;
    }
  }
  return nodes;
}

/// True if all nodes of a face lie in the plane where a coordinate is zero.
bool lies_at_zero(const Mesh &mesh, const MeshFace &face, unsigned axis)
{
  for (unsigned v = 0; v < mesh.nodes_per_face(); ++v)
    if (mesh.nodes[face.nodes[v]][axis] != 0)
      return false;
  return true;
}

/// True on the axis and on planes of symmetry.
bool lies_inside_the_compact(const Mesh &mesh, const MeshFace &face)
{
  switch (mesh.section) {
  case Section::axisymmetric:
    return lies_at_zero(mesh, face, 0);
  case Section::quarter:
    return lies_at_zero(mesh, face, 0) || lies_at_zero(mesh, face, 1);
  default:
    return false;
  }
}

/// Gives the boundary faces to the tools.
/// @param base  number of nodes of a slice.
void find_tools(const DieGeometry &geometry, std::size_t base, Mesh &mesh)
{
  const bool ring = geometry.shape == DieShape::ring;
  const double middle = 0.5 * (geometry.core_radius + geometry.radius);
  for (const MeshFace &face : boundary_faces(mesh)) {
    const std::span nodes(face.nodes.data(), mesh.nodes_per_face());
    const auto [lowest, highest] =
        std::minmax_element(nodes.begin(), nodes.end());
    Vector across = centre_of(mesh, nodes);
    across[2] = 0;
    if (*highest < base)
      add_face(mesh, face, mesh.tools[lower_punch]);
    else if (*lowest >= base * geometry.axial_elements)
      add_face(mesh, face, mesh.tools[upper_punch]);
    else if (!lies_inside_the_compact(mesh, face))
      add_face(
          mesh,
          face,
          mesh.tools[ring && across.norm() < middle ? core_rod : die_wall]);
  }
  collect_nodes(mesh);
}

void hold_symmetry(Mesh &mesh)
{
  for (unsigned n = 0; n < mesh.nodes.size(); ++n) {
    const bool zero_x = mesh.nodes[n][0] == 0, zero_y = mesh.nodes[n][1] == 0;
    const bool full = mesh.section == Section::full;
    if (zero_x && (!full || zero_y))
      mesh.held.push_back({n, 0});
    if (zero_y && !mesh.is_axisymmetric() && (!full || zero_x))
      mesh.held.push_back({n, 1});
  }
}
} // namespace

Mesh build_mesh(const DieGeometry &geometry)
{
  geometry.check();
  if (geometry.shape == DieShape::file)
    throw std::invalid_argument("a mesh of shape 'file' is read, not built");
  const PlaneSection section = section_of(geometry);
  Mesh mesh;
  mesh.section = geometry.section;
  mesh.nodes = place_nodes(geometry, section);
  const auto base = static_cast<unsigned>(section.nodes.size());
  for (unsigned layer = 0; layer < geometry.axial_elements; ++layer)
    for (unsigned cell = 0; cell < section.number_of_cells(); ++cell)
      for (const unsigned slice : {layer, layer + 1})
        for (unsigned v = 0; v < section.nodes_per_cell; ++v)
          mesh.cells.push_back(
              slice * base + section.cells[cell * section.nodes_per_cell + v]);
  find_tools(geometry, base, mesh);
  hold_symmetry(mesh);
  return mesh;
}
} // namespace tamp::fem
