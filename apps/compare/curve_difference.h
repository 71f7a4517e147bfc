// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_compare_curve_difference_h
#define apps_compare_curve_difference_h

#include <optional>
#include <span>
#include <vector>

namespace tamp::apps
{
/// A curve y(x), linear between its points, whose x grow.
struct PlainCurve {
  std::vector<double> x, y;
};

/// The part of recorded points that goes on in the direction of the whole:
/// those whose x is beyond all before it, turned over if x falls. Points that
/// are not finite are left out.
PlainCurve monotone_part(std::span<const double> x, std::span<const double> y);

/// How far a curve is from a reference over the range that both have.
struct CurveDifference {
  double from = 0, to = 0; ///< the range of x
  /// Root of the integral of the squared difference over that of the squared
  /// reference [-].
  double relative_L2 = 0;
  /// The largest difference over the largest value of the reference [-].
  double relative_largest = 0;
  double at = 0; ///< the x of the largest difference
};

/// The integrals are exact: between the points of both curves the difference is
/// linear. None if the curves have no range in common, or the reference is zero
/// all over it.
std::optional<CurveDifference> difference_of(const PlainCurve &reference,
                                             const PlainCurve &other);
} // namespace tamp::apps

#endif
