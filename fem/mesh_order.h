// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_mesh_order_h
#define fem_mesh_order_h

#include <fem/mesh.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace tamp::fem
{
/// Indices of positions from below: along z, within a layer of equal z along y,
/// then along x. Coordinates that differ by less than 1e-9 of the extent count
/// as equal; what lies at one place keeps its order.
std::vector<unsigned>
order_from_below(const std::vector<dealii::Tensor<1, 3>> &positions);

/// Numbers nodes and cells (by their centres) from below, so that ranges of
/// both are slabs across the pressing axis. Lists of tools and held nodes
/// follow.
void renumber_from_below(Mesh &mesh);
} // namespace tamp::fem

#endif
