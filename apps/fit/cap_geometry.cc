// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/cap_geometry.h>

#include <algorithm>
#include <cmath>

namespace tamp::apps
{
namespace
{
/// Sums over points with the weight 1 / q^2: the normal equations of relative
/// differences.
struct RelativeSums {
  double one = 0, p = 0, pp = 0, q = 0, pq = 0;
  bool one_pressure = false;

  explicit RelativeSums(std::span<const StressPoint> points)
  {
    for (const StressPoint &point : points) {
      const double weight = 1 / (point.q * point.q);
      one += weight;
      p += weight * point.p;
      pp += weight * point.p * point.p;
      q += weight * point.q;
      pq += weight * point.p * point.q;
    }
    const auto [least, most] = std::ranges::minmax(points, {}, &StressPoint::p);
    one_pressure = !(most.p - least.p > 0.1 * most.p);
  }
  double determinant() const { return one * pp - p * p; }
};
} // namespace

ShearLine fit_shear_line(std::span<const StressPoint> points)
{
  const RelativeSums sums(points);
  ShearLine line;
  line.through_origin = sums.one_pressure;
  if (!line.through_origin) {
    line.cohesion = (sums.q * sums.pp - sums.p * sums.pq) / sums.determinant();
    line.slope = (sums.one * sums.pq - sums.p * sums.q) / sums.determinant();
  }
  if (line.through_origin || line.cohesion < 0) {
    line.cohesion = 0;
    line.slope = sums.pp > 0 ? sums.pq / sums.pp : 0;
  }
  return line;
}

double cohesion_error(std::span<const StressPoint> points)
{
  if (points.size() < 3)
    return 0;
  const RelativeSums sums(points);
  if (sums.one_pressure)
    return 0;
  const ShearLine line = fit_shear_line(points);
  double square = 0;
  for (const StressPoint &point : points)
    square += std::pow(line.at(point.p) / point.q - 1, 2);
  return std::sqrt(square / static_cast<double>(points.size() - 2) * sums.pp /
                   sums.determinant());
}

double residual_of(const ShearLine &line, std::span<const StressPoint> points)
{
  double sum = 0;
  for (const StressPoint &point : points)
    sum += std::pow(point.q / line.at(point.p) - 1, 2);
  return points.empty() ? 0
                        : std::sqrt(sum / static_cast<double>(points.size()));
}

std::optional<Cap> cap_by_flow(const ShearLine &line,
                               const StressPoint &stress,
                               double plastic_ratio)
{
  const auto [p, q] = stress;
  const double d = line.cohesion, t = line.slope;
  if (!(plastic_ratio > 0 && q > 0 && q < line.at(p)))
    return {};
  const double half = d * t + plastic_ratio * q / 2,
               constant = d * d - plastic_ratio * p * q - q * q;
  // The larger root, without cancellation where it is positive.
  const double root = std::sqrt(half * half - t * t * constant);
  Cap cap;
  cap.centre = half + root > 0 ? -constant / (half + root) : 0;
  cap.eccentricity = std::sqrt((p - cap.centre) / (plastic_ratio * q));
  cap.yield_pressure = cap.centre + cap.eccentricity * line.at(cap.centre);
  return cap;
}

std::optional<Cap> cap_through(const ShearLine &line,
                               double eccentricity,
                               const StressPoint &stress)
{
  const auto [p, q] = stress;
  const double d = line.cohesion, t = line.slope;
  if (!(q < line.at(p)))
    return {};
  // (1 - R^2 t^2) p_a^2 - 2 (p + R^2 d t) p_a + p^2 + R^2 (q^2 - d^2) = 0: the
  // root on this side of p.
  const double square = eccentricity * eccentricity, a = 1 - square * t * t,
               b = p + square * d * t, c = p * p + square * (q * q - d * d);
  Cap cap;
  cap.eccentricity = eccentricity;
  cap.centre = c / (b + std::sqrt(std::max(0., b * b - a * c)));
  cap.yield_pressure = cap.centre + eccentricity * line.at(cap.centre);
  return cap;
}
} // namespace tamp::apps
