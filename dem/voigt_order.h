// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_voigt_order_h
#define dem_voigt_order_h

#include <dem/tensors.h>

#include <array>

namespace tamp::dem
{
/// Row and column of a component of a symmetric tensor.
struct Component {
  int row, column;
};

/// The order of the six components: xx, yy, zz, yz, xz, xy.
inline constexpr std::array<Component, 6> voigt_order = {
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

/// The symmetric tensor whose component k, and its mirror image, is 1.
inline Matrix3 unit_strain(int k)
{
  const auto [a, b] = voigt_order[k];
  Matrix3 strain = Matrix3::Zero();
  strain(a, b) = strain(b, a) = 1;
  return strain;
}

/// The six components of the symmetric part of a tensor.
inline Eigen::Matrix<double, 6, 1> voigt_components(const Matrix3 &tensor)
{
  Eigen::Matrix<double, 6, 1> result;
  for (int k = 0; k < 6; ++k) {
    const auto [a, b] = voigt_order[k];
    result[k] = 0.5 * (tensor(a, b) + tensor(b, a));
  }
  return result;
}
} // namespace tamp::dem

#endif
