// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_periodic_box_h
#define dem_periodic_box_h

#include <dem/tensors.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
/// A triclinic cell that repeats in three directions. A point is x = h s with
/// fractional coordinates s; s and s + integers are the same grain.
struct PeriodicBox {
  Matrix3 h = Matrix3::Identity(); ///< edges as columns [m]

  /// [m3], positive for a right-handed box.
  double volume() const { return h.determinant(); }

  /// Smallest distance between opposite faces [m].
  double smallest_width() const
  {
    const Matrix3 inverse = h.inverse();
    return 1 / inverse.rowwise().norm().maxCoeff();
  }

  /// The branch vector of the nearest image for a difference of fractional
  /// coordinates [m]. Exact up to half of smallest_width().
  Vector3 nearest_image(Vector3 difference) const
  {
    for (int a = 0; a < 3; ++a)
      difference[a] -= std::nearbyint(difference[a]);
    return h * difference;
  }

  bool operator==(const PeriodicBox &other) const { return h == other.h; }
};
} // namespace tamp::dem

#endif
