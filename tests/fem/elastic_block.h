// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_fem_elastic_block_h
#define tests_fem_elastic_block_h

#include <fem/ranks.h>
#include <fem/sparse_rows.h>

#include <array>
#include <cstddef>
#include <vector>

namespace tamp::fem::test
{
/// Unit cubes of an elastic material (Young's modulus 1, Poisson's ratio 0.3),
/// clamped at the bottom, whose nodes are no unknowns. Springs hold one side.
struct ElasticBlock {
  std::array<int, 3> cells = {4, 4, 4}; ///< along x, y, z
  double penalty = 0;  ///< stiffness of springs normal to the side x = largest
  double friction = 0; ///< downward force / spring force: unsymmetric

  std::size_t cell_count() const;
  std::size_t unknowns() const; ///< three per node, one after another
};

/// The part of the stiffness that these cells give.
SparseRows stiffness(const ElasticBlock &block, const Share &cells);
SparseRows stiffness(const ElasticBlock &block);

/// Three translations and three rotations.
std::vector<std::vector<double>> rigid_modes(const ElasticBlock &block);

/// Forces on all nodes that have no pattern.
std::vector<double> forces(const ElasticBlock &block);
} // namespace tamp::fem::test

#endif
