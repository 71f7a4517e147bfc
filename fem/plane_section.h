// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_plane_section_h
#define fem_plane_section_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace tamp::fem
{
/// A grid across the pressing axis, in z = 0, to be drawn along it: lines along
/// the radius (two nodes a cell) or quadrilaterals (four, lexicographic).
/// Nodes and cells are numbered along y, then x.
struct PlaneSection {
  std::vector<dealii::Tensor<1, 3>> nodes; ///< [m]
  std::vector<unsigned> cells;
  unsigned nodes_per_cell = 4;

  unsigned number_of_cells() const
  {
    return static_cast<unsigned>(cells.size()) / nodes_per_cell;
  }
};

/// Lines along the radius with nodes at these places [m].
PlaneSection radial_section(const std::vector<double> &radii);

/// The quarter x >= 0, y >= 0 of a square with rounded corners: `half_side`
/// from the axis to a side, `corner_radius` from zero (a square) to half_side
/// (a disc) [m], about `elements` along half a side. A brick's grid with its
/// corner on the arc where an element is longer than the radius, else a square
/// block within rings that follow the outline. Inner nodes are means of their
/// neighbours, which never inverts a cell of a convex section (W. T. Tutte,
/// How to draw a graph, 1963).
PlaneSection
rounded_square(double half_side, double corner_radius, unsigned elements);

/// The quarter of a ring with nodes at these radii [m].
PlaneSection ring_section(const std::vector<double> &radii);

/// A quarter and its images in the planes x = 0 and y = 0.
PlaneSection mirrored(const PlaneSection &quarter);
} // namespace tamp::fem

#endif
