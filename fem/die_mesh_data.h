// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_die_mesh_data_h
#define fem_die_mesh_data_h

#include <fem/die_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace tamp::fem
{
/// Bilinear shape functions at one Gauss point of the reference square.
struct ReferencePoint {
  std::array<double, 4> value;
  std::array<dealii::Tensor<1, 2>, 4> gradient;
  double weight = 0;
};

/// The mesh as plain arrays: everything the solver needs of it. Node and cell
/// numbers are those of the deal.II triangulation; the nodes of a cell are in
/// deal.II's (lexicographic) order. Degree of freedom 2 n + c is component c
/// (0: r, 1: z) of node n. Material point 4 c + q is Gauss point q of cell c.
struct DieMesh::Data {
  std::vector<dealii::Tensor<1, 2>> nodes; ///< (r, z) at the start [m]
  std::vector<std::array<unsigned, 4>> cells;
  std::vector<unsigned> axis; ///< nodes at r = 0, from below
  std::vector<unsigned> wall; ///< nodes on the die wall, from below
  std::vector<unsigned> punch_bottom; ///< from the axis outwards
  std::vector<unsigned> punch_top;    ///< from the axis outwards
  std::array<ReferencePoint, 4> reference; ///< QGauss<2>(2)
  std::vector<dealii::Tensor<1, 2>> points; ///< (r, z) at the start [m]
  double radius = 0; ///< [m]
  double bottom = 0; ///< z of the lower punch at the start [m]
  double top = 0;    ///< z of the upper punch at the start, the rim [m]

  std::size_t number_of_dofs() const { return 2 * nodes.size(); }
  std::size_t number_of_points() const { return 4 * cells.size(); }
};
} // namespace tamp::fem

#endif
