// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_profile_h
#define fem_profile_h

#include <deal.II/base/tensor.h>

#include <vector>

namespace tamp::fem
{
/// What a profile says at a place.
struct ProfilePoint {
  double distance = 0;         ///< [m]; positive on the left of the profile
  dealii::Tensor<1, 2> normal; ///< unit, towards the left
  double curvature = 0;        ///< d normal / d x along the tangent [1/m]
};

/// A chain of straight lines and circular arcs in a plane, the trace of a rigid
/// tool's surface. Seen along the chain the powder is on the left and the tool
/// on the right. The first and the last piece go on straight for ever.
class Profile
{
public:
  using Point = dealii::Tensor<1, 2>;

  /// @param corners  at least two; successive ones must differ [m].
  /// @param radii    of the arc that rounds each inner corner; empty: sharp
  ///                 corners [m]. Throws std::invalid_argument naming the
  ///                 corner if an arc does not fit between its neighbours.
  explicit Profile(std::vector<Point> corners, std::vector<double> radii = {});

  /// The closest place of the profile, as seen from `position`. On the arc's
  /// side the curvature is that of the offset curve through `position`, so
  /// that the normal's derivative is exact.
  ProfilePoint nearest(const Point &position) const;
};
} // namespace tamp::fem

#endif
