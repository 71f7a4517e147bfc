// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_mesh_faces_h
#define fem_mesh_faces_h

#include <fem/mesh.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tamp::fem
{
/// A face (an edge in an axisymmetric mesh) of a cell.
struct MeshFace {
  std::array<unsigned, 4> nodes{}; ///< Mesh::nodes_per_face() count
  std::size_t cell = 0;            ///< the lowest one that has this face
  std::size_t neighbour = 0;       ///< the next one, if there are two
  unsigned number_of_cells = 1;    ///< 1: on the boundary
};

/// The nodes of a face in ascending order: equal for equal faces.
/// @param count  how many of them count.
using FaceKey = std::array<unsigned, 4>;
FaceKey face_key(FaceKey nodes, unsigned count);

/// Every face of the mesh once, ordered by its cell and its number there. The
/// nodes stand in deal.II's order.
std::vector<MeshFace> mesh_faces(const Mesh &mesh);

/// The faces that one cell has alone.
std::vector<MeshFace> boundary_faces(const Mesh &mesh);

/// Mean of the positions of some nodes [m].
dealii::Tensor<1, 3> centre_of(const Mesh &mesh,
                               std::span<const unsigned> nodes);

/// Gives a tool this face.
void add_face(const Mesh &mesh, const MeshFace &face, Mesh::Contact &contact);

/// Fills the list of nodes of every tool from its faces.
void collect_nodes(Mesh &mesh);
} // namespace tamp::fem

#endif
