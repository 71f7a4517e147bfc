// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_element_h
#define fem_element_h

#include <deal.II/base/tensor.h>

#include <array>

namespace tamp::fem
{
/// Multilinear shape functions at one place of the reference cell.
struct ShapeValues {
  std::array<double, 8> value;
  /// By the reference coordinates; those of a quadrilateral are axes 0 and 2.
  std::array<dealii::Tensor<1, 3>, 8> gradient;
  double weight = 0; ///< of the Gauss point in the unit cell
};

/// A four-node quadrilateral or an eight-node hexahedron on the unit cell, with
/// two Gauss points along each direction. Nodes and points are numbered
/// lexicographically, x fastest.
struct Element {
  std::array<ShapeValues, 8> points; ///< as many as nodes
  ShapeValues centre;

  explicit Element(bool is_quadrilateral);
};
} // namespace tamp::fem

#endif
