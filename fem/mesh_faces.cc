// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_faces.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace tamp::fem
{
namespace
{
/// Places of a face's nodes in its cell, in deal.II's order.
constexpr unsigned edges_of_square[4][2] = {{0, 2}, {1, 3}, {0, 1}, {2, 3}};
constexpr unsigned faces_of_cube[6][4] = {{0, 2, 4, 6},
                                          {1, 3, 5, 7},
                                          {0, 4, 1, 5},
                                          {2, 6, 3, 7},
                                          {0, 1, 2, 3},
                                          {4, 5, 6, 7}};

/// A face with its nodes sorted, by which equal faces are found.
struct KeyedFace {
  FaceKey key;
  std::size_t place; ///< cell by cell
  MeshFace face;
};

std::vector<KeyedFace> faces_of_cells(const Mesh &mesh)
{
  const unsigned per_face = mesh.nodes_per_face();
  const unsigned faces = mesh.is_axisymmetric() ? 4 : 6;
  std::vector<KeyedFace> all;
  all.reserve(mesh.number_of_cells() * faces);
  for (std::size_t cell = 0; cell < mesh.number_of_cells(); ++cell)
    for (unsigned f = 0; f < faces; ++f) {
      const unsigned *places =
          mesh.is_axisymmetric() ? edges_of_square[f] : faces_of_cube[f];
      KeyedFace keyed{{}, all.size(), {}};
      keyed.face.cell = cell;
      for (unsigned v = 0; v < per_face; ++v)
        keyed.face.nodes[v] = mesh.nodes_of_cell(cell)[places[v]];
      keyed.key = face_key(keyed.face.nodes, per_face);
      all.push_back(keyed);
    }
  return all;
}
} // namespace

FaceKey face_key(FaceKey nodes, unsigned count)
{
  std::fill(
      nodes.begin() + count, nodes.end(), std::numeric_limits<unsigned>::max());
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

std::vector<MeshFace> mesh_faces(const Mesh &mesh)
{
  std::vector<KeyedFace> all = faces_of_cells(mesh);
  std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
    return std::pair(a.key, a.place) < std::pair(b.key, b.place);
  });
  std::vector<KeyedFace> unique;
  for (const KeyedFace &keyed : all) {
    if (unique.empty() || unique.back().key != keyed.key) {
      unique.push_back(keyed);
      continue;
    }
    MeshFace &face = unique.back().face;
    if (++face.number_of_cells == 2)
      face.neighbour = keyed.face.cell;
  }
  std::sort(unique.begin(), unique.end(), [](const auto &a, const auto &b) {
    return a.place < b.place;
  });
  std::vector<MeshFace> faces;
  faces.reserve(unique.size());
  for (const KeyedFace &keyed : unique)
    faces.push_back(keyed.face);
  return faces;
}

std::vector<MeshFace> boundary_faces(const Mesh &mesh)
{
  std::vector<MeshFace> faces = mesh_faces(mesh);
  std::erase_if(faces,
                [](const MeshFace &face) { return face.number_of_cells > 1; });
  return faces;
}

dealii::Tensor<1, 3> centre_of(const Mesh &mesh,
                               std::span<const unsigned> nodes)
{
  dealii::Tensor<1, 3> centre;
  for (const unsigned node : nodes)
    centre += mesh.nodes[node];
  return centre / static_cast<double>(nodes.size());
}

void add_face(const Mesh &mesh, const MeshFace &face, Mesh::Contact &contact)
{
  contact.faces.insert(contact.faces.end(),
                       face.nodes.begin(),
                       face.nodes.begin() + mesh.nodes_per_face());
}

void collect_nodes(Mesh &mesh)
{
  for (Mesh::Contact &tool : mesh.tools) {
    tool.nodes = tool.faces;
    std::sort(tool.nodes.begin(), tool.nodes.end());
    tool.nodes.erase(std::unique(tool.nodes.begin(), tool.nodes.end()),
                     tool.nodes.end());
  }
}
} // namespace tamp::fem
