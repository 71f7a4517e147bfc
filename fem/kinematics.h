// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_kinematics_h
#define fem_kinematics_h

#include <fem/element.h>
#include <fem/material_points.h>
#include <fem/mesh.h>

#include <array>
#include <span>
#include <vector>

namespace tamp::fem
{
/// Positions of all nodes [m].
using NodePositions = std::vector<dealii::Tensor<1, 3>>;

/// A place of a cell in a given geometry.
struct PointGeometry {
  std::array<double, 8> value;                  ///< shape functions [-]
  std::array<dealii::Tensor<1, 3>, 8> gradient; ///< d N / d x [1/m]
  dealii::Tensor<1, 3> position;                ///< [m]
  double volume = 0; ///< of the point, of the full ring if axisymmetric [m3];
                     ///< <= 0: inverted
};

/// Geometry of a cell's place if the nodes are at `positions`.
/// @param nodes  of the cell.
PointGeometry point_geometry(const Mesh &mesh,
                             const ShapeValues &shape,
                             const unsigned *nodes,
                             const NodePositions &positions);

/// Where the material points of a mesh are at the start [m], cell after cell.
std::vector<dealii::Tensor<1, 3>> point_positions(const Mesh &mesh);

/// Gradient of a displacement at a place. Axisymmetric: with the hoop strain in
/// the axes (r, theta, z). @param displacement  of all degrees of freedom [m].
dealii::Tensor<2, 3>
displacement_gradient(const Mesh &mesh,
                      const PointGeometry &geometry,
                      const unsigned *nodes,
                      std::span<const double> displacement);

/// How far a body reaches [m].
struct Extent {
  double low = 0, high = 0; ///< z of its lowest and its highest node
  double radius = 0;        ///< largest distance from the axis

  double height() const { return high - low; }
};

Extent extent(const NodePositions &positions);

/// Positions of the nodes moved by a displacement of all degrees of freedom.
NodePositions moved(const Mesh &mesh,
                    const NodePositions &positions,
                    std::span<const double> displacement);
} // namespace tamp::fem

#endif
