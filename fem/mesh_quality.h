// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_mesh_quality_h
#define fem_mesh_quality_h

#include <fem/mesh.h>

#include <deal.II/base/tensor.h>

#include <cstddef>
#include <string>

namespace tamp::fem
{
/// How well the cells of a mesh are shaped.
struct MeshQuality {
  std::size_t nodes = 0, cells = 0;
  /// The smallest scaled Jacobian: the determinant of the unit edges at a
  /// cell's corner [-]. 1 is a brick; zero or less cannot be computed with.
  /// Source: Stimpson et al., The Verdict Geometric Quality Library (2007).
  double scaled_jacobian = 1;
  dealii::Tensor<1, 3> worst_place; ///< centre of the cell that has it [m]
  /// The largest ratio of the longest to the shortest edge of a cell [-].
  double aspect_ratio = 1;
  double shortest_edge = 0, longest_edge = 0; ///< of all cells [m]
};

MeshQuality mesh_quality(const Mesh &mesh);

/// Volume of the mesh [m^3], exact for its cells; of a quarter it is that of
/// the quarter, of an axisymmetric mesh that of the whole ring.
double mesh_volume(const Mesh &mesh);

/// The figures in a line for people.
std::string describe(const MeshQuality &quality);

/// A place in a message, in mm: "(r, z) = (1, 2) mm" or "(x, y, z) = ...".
std::string describe_place(const Mesh &mesh,
                           const dealii::Tensor<1, 3> &position);
} // namespace tamp::fem

#endif
