// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_assembler_h
#define fem_assembler_h

#include <fem/kinematics.h>
#include <fem/ranks.h>
#include <fem/sparse_rows.h>

#include <span>
#include <vector>

namespace tamp::fem
{
/// What a cell gives to forces and stiffness.
struct CellPoints {
  std::span<const PointGeometry> points;
  std::span<const Response> responses;
  const PointGeometry *centre = nullptr; ///< only with the F-bar element
};

/// Assembles the forces and the stiffness of a range of cells, whose place in
/// the matrix is looked up once.
class Assembler
{
public:
  /// @param cells  that this rank assembles. Mesh must outlive the object.
  Assembler(const Mesh &mesh, const Share &cells);

  /// Zero matrix over all degrees of freedom; rows that no cell of the share
  /// touches are empty.
  const SparseRows &pattern() const { return pattern_; }

  /// Adds to `force` the forces that hold the Cauchy stress of a cell's points
  /// [N]: f_a = int sigma . grad N_a dv, one per degree of freedom.
  void add_forces(std::size_t cell,
                  const CellPoints &points,
                  std::span<double> force) const;

  /// Adds to `stiffness`, of the pattern, the derivative of these forces by the
  /// displacement [N/m], from the material tangents: consistent, hence
  /// unsymmetric,
  /// d f = int [(C : eps* + W sigma - sigma W) : G + sigma : G tr L
  ///            - (sigma L^T) : G] dv, with L = grad du, eps + W = L, G = grad
  /// N. eps* is eps, but with the F-bar element its volumetric part is that at
  /// the cell's centre (de Souza Neto et al. 1996).
  void add_stiffness(std::size_t cell,
                     const CellPoints &points,
                     SparseRows &stiffness) const;

private:
  const Mesh &mesh_;
  Share cells_;
  SparseRows pattern_;
  /// Of each pair of nodes of each cell: place of the first column of node b in
  /// the rows of node a, from their begin on.
  std::vector<int> offsets_;
};
} // namespace tamp::fem

#endif
