// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_kinematics_h
#define fem_kinematics_h

#include <fem/die_mesh_data.h>
#include <fem/material_points.h>

#include <array>
#include <vector>

namespace tamp::fem
{
/// Positions of all nodes (r, z) [m].
using NodePositions = std::vector<dealii::Tensor<1, 2>>;

/// Displacement of all degrees of freedom, 2 n + component [m].
using Displacement = std::vector<double>;

/// A material point of a cell in a given geometry.
struct PointGeometry {
  std::array<double, 4> value;                   ///< shape functions [-]
  std::array<dealii::Tensor<1, 2>, 4> gradient;  ///< d N / d (r, z) [1/m]
  dealii::Tensor<1, 2> position;                 ///< (r, z) [m]
  double volume = 0; ///< of the full ring, 2 pi r dA [m3]; <= 0: inverted
};

/// Geometry of material point `point` if the nodes are at `positions`.
PointGeometry point_geometry(const DieMesh::Data &mesh,
                             const NodePositions &positions,
                             std::size_t point);

/// Positions of the nodes moved by a displacement.
NodePositions moved(const NodePositions &positions,
                    const Displacement &displacement);

/// Relative deformation gradient of every point, in the axes (r, theta, z), for
/// an increment of displacement from `committed` on.
void relative_deformations(const DieMesh::Data &mesh,
                           const NodePositions &committed,
                           const Displacement &increment,
                           std::vector<Deformation> &deformations);

/// Largest component of relative_F - I over all points [-].
double largest_strain(const std::vector<Deformation> &deformations);
} // namespace tamp::fem

#endif
