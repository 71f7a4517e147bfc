// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_six_h
#define dem_six_h

#include <dem/tensors.h>

#include <array>
#include <utility>

namespace tamp::dem
{
/// The components of a symmetric tensor in the order xx, yy, zz, yz, xz, xy.
using Six = Eigen::Matrix<double, 6, 1>;

/// Row and column of each.
constexpr std::array<std::pair<int, int>, 6> six_places = {
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

/// The components of the symmetric part.
inline Six to_six(const Matrix3 &tensor)
{
  Six result;
  for (int k = 0; k < 6; ++k) {
    const auto [a, b] = six_places[k];
    result[k] = 0.5 * (tensor(a, b) + tensor(b, a));
  }
  return result;
}

/// The symmetric tensor with these components.
inline Matrix3 from_six(const Six &components)
{
  Matrix3 result;
  for (int k = 0; k < 6; ++k) {
    const auto [a, b] = six_places[k];
    result(a, b) = result(b, a) = components[k];
  }
  return result;
}

/// The symmetric tensor whose component k, and its mirror image, is 1.
inline Matrix3 unit_strain(int k)
{
  return from_six(Six::Unit(k));
}
} // namespace tamp::dem

#endif
