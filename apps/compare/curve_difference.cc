// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/curve_difference.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tamp::apps
{
namespace
{
// Of a curve at a place within its range.
double value_at(const PlainCurve &curve, double x)
{
  const auto after = std::ranges::lower_bound(curve.x, x);
  const auto i = static_cast<std::size_t>(after - curve.x.begin());
  if (i == 0)
    return curve.y.front();
  if (i == curve.x.size())
    return curve.y.back();
  const double share = (x - curve.x[i - 1]) / (curve.x[i] - curve.x[i - 1]);
  return curve.y[i - 1] + share * (curve.y[i] - curve.y[i - 1]);
}

// Integral of the square of what is linear from a to b over a unit length.
double mean_square(double a, double b)
{
  return (a * a + a * b + b * b) / 3;
}

// The ends of the range and the points of both curves between them.
std::vector<double> places_of(const PlainCurve &first,
                              const PlainCurve &second,
                              double from,
                              double to)
{
  std::vector<double> places{from, to};
  for (const PlainCurve *curve : {&first, &second})
    for (const double x : curve->x)
      if (x > from && x < to)
        places.push_back(x);
  std::ranges::sort(places);
  return places;
}
} // namespace

PlainCurve monotone_part(std::span<const double> x, std::span<const double> y)
{
  assert(x.size() == y.size());
  PlainCurve curve;
  std::vector<std::size_t> finite;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::isfinite(x[i]) && std::isfinite(y[i]))
      finite.push_back(i);
  if (finite.empty())
    return curve;
  const double sign = x[finite.back()] < x[finite.front()] ? -1 : 1;
  for (const std::size_t i : finite)
    if (curve.x.empty() || sign * (x[i] - curve.x.back()) > 0) {
      curve.x.push_back(x[i]);
      curve.y.push_back(y[i]);
    }
  if (sign < 0) {
    std::ranges::reverse(curve.x);
    std::ranges::reverse(curve.y);
  }
  return curve;
}

std::optional<CurveDifference> difference_of(const PlainCurve &reference,
                                             const PlainCurve &other)
{
  if (reference.x.size() < 2 || other.x.size() < 2)
    return {};
  CurveDifference result;
  result.from = std::max(reference.x.front(), other.x.front()) + 0.; // no -0
  result.to = std::min(reference.x.back(), other.x.back());
  if (!(result.from < result.to))
    return {};
  double squares = 0, reference_squares = 0, largest = 0, reference_largest = 0;
  double before = 0, difference_before = 0, reference_before = 0;
  bool first = true;
  for (const double x : places_of(reference, other, result.from, result.to)) {
    const double value = value_at(reference, x);
    const double difference = value_at(other, x) - value;
    if (first || std::abs(difference) > largest) {
      largest = std::abs(difference);
      result.at = x;
    }
    reference_largest = std::max(reference_largest, std::abs(value));
    if (!first) {
      squares += (x - before) * mean_square(difference_before, difference);
      reference_squares += (x - before) * mean_square(reference_before, value);
    }
    before = x;
    difference_before = difference;
    reference_before = value;
    first = false;
  }
  if (!(reference_squares > 0))
    return {};
  result.relative_L2 = std::sqrt(squares / reference_squares);
  result.relative_largest = largest / reference_largest;
  return result;
}
} // namespace tamp::apps
