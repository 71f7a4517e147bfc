// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_defects.h>
#include <fem/mesh_order.h>
#include <fem/mesh_quality.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <span>

namespace tamp::fem
{
namespace
{
using Vector = dealii::Tensor<1, 3>;
/// Places closer than this share of the extent are one [-].
constexpr double tolerance = 1e-9;

std::string describe_twins(const Mesh &mesh)
{
  const std::vector<unsigned> order = order_from_below(mesh.nodes);
  const double extent =
      (mesh.nodes[order.back()] - mesh.nodes[order.front()]).norm();
  std::size_t twins = 0;
  std::optional<unsigned> first;
  for (std::size_t i = 1; i < order.size(); ++i)
    if ((mesh.nodes[order[i]] - mesh.nodes[order[i - 1]]).norm() <=
        tolerance * extent) {
      ++twins;
      if (!first)
        first = order[i];
    }
  if (!first)
    return "";
  return "has nodes that lie where others do but are not joined with them: " +
         std::to_string(twins) + ", the first at " +
         describe_place(mesh, mesh.nodes[*first]) +
         "; use 'Coherence;' in the geometry or 'Coherence Mesh;' after "
         "meshing";
}

std::string describe_overlaps(const Mesh &mesh)
{
  for (const MeshFace &face : mesh_faces(mesh))
    if (face.number_of_cells > 2)
      return "cells overlap: " + std::to_string(face.number_of_cells) +
             " of them share the face at " +
             describe_place(
                 mesh,
                 centre_of(mesh, {face.nodes.data(), mesh.nodes_per_face()}));
  return "";
}

/// A node of one face that lies within an edge of another.
std::optional<unsigned> find_hanging_node(const Mesh &mesh,
                                          const std::vector<MeshFace> &faces)
{
  std::set<unsigned> nodes;
  for (const MeshFace &face : faces)
    nodes.insert(face.nodes.begin(),
                 face.nodes.begin() + mesh.nodes_per_face());
  constexpr unsigned edges[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
  const std::span used(edges, mesh.is_axisymmetric() ? 1 : 4);
  for (const MeshFace &face : faces)
    for (const auto &edge : used) {
      const Vector &from = mesh.nodes[face.nodes[edge[0]]];
      const Vector along = mesh.nodes[face.nodes[edge[1]]] - from;
      for (const unsigned node : nodes) {
        const Vector offset = mesh.nodes[node] - from;
        const double share = offset * along / along.norm_square();
        if (share > 1e-6 && share < 1 - 1e-6 &&
            (offset - share * along).norm() < 1e-6 * along.norm())
          return node;
      }
    }
  return {};
}
} // namespace

std::string describe_joints(const Mesh &mesh)
{
  const std::string twins = describe_twins(mesh);
  return twins.empty() ? describe_overlaps(mesh) : twins;
}

std::string describe_islands(const Mesh &mesh)
{
  std::vector<std::size_t> parent(mesh.number_of_cells());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto root = [&](std::size_t cell) {
    while (parent[cell] != cell)
      cell = parent[cell] = parent[parent[cell]];
    return cell;
  };
  for (const MeshFace &face : mesh_faces(mesh))
    if (face.number_of_cells == 2)
      parent[root(face.neighbour)] = root(face.cell);
  std::size_t islands = 0, other = 0;
  for (std::size_t cell = 0; cell < parent.size(); ++cell)
    if (root(cell) == cell) {
      ++islands;
      if (root(0) != cell)
        other = cell;
    }
  if (islands == 1)
    return "";
  return "has " + std::to_string(islands) +
         " parts that share no faces, one of them at " +
         describe_place(
             mesh,
             centre_of(mesh,
                       {mesh.nodes_of_cell(other), mesh.nodes_per_cell()})) +
         "; mesh one body of powder";
}

std::string describe_bare_faces(const GmshFile &file,
                                const std::vector<MeshFace> &faces)
{
  const Mesh &mesh = file.mesh;
  if (const auto node = find_hanging_node(mesh, faces))
    return "has a hanging node at " + describe_place(mesh, mesh.nodes[*node]) +
           ": it lies within an edge of another cell; give both sides the "
           "same number of elements";
  std::string text = describe_islands(mesh);
  if (!text.empty())
    return text;
  const FaceKey key = face_key(faces.front().nodes, mesh.nodes_per_face());
  const auto name = file.names.find(file.face_ids.at(key));
  text =
      "has faces on its boundary that belong to no tool: " +
      std::to_string(faces.size()) + ", the first at " +
      describe_place(
          mesh,
          centre_of(mesh, {faces.front().nodes.data(), mesh.nodes_per_face()}));
  if (name != file.names.end())
    text += " to '" + name->second + "', which is no known name";
  text += "; the names are 'die_wall', 'punch_top', 'punch_bottom', 'core'";
  return text + (mesh.is_axisymmetric() ? " and 'axis'"
                                        : ", 'symmetry_x' and 'symmetry_y'");
}
} // namespace tamp::fem
