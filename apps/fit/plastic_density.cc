// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/plastic_density.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tamp::apps
{
namespace
{
/// Two densities that differ by less, relative, are one.
constexpr double same_density = 1e-6;

// ln y, linear in ln x between two rows and beyond them.
double power(double x, double x0, double y0, double x1, double y1)
{
  const double share = std::log(x / x0) / std::log(x1 / x0);
  return std::exp((1 - share) * std::log(y0) + share * std::log(y1));
}

// Linear in x, constant beyond the ends. Works where x does not decrease.
template <class Points, class X, class Y>
double interpolated(const Points &points, double at, X x, Y y)
{
  const auto above = std::ranges::upper_bound(points, at, {}, x);
  if (above == points.begin())
    return y(points.front());
  if (above == points.end())
    return y(points.back());
  const auto below = above - 1;
  const double share = (at - x(*below)) / (x(*above) - x(*below));
  return (1 - share) * y(*below) + share * y(*above);
}
} // namespace

PathElasticity::PathElasticity(std::vector<ModuliPoint> rows, bool unloaded)
    : unloaded_(unloaded)
{
  std::ranges::stable_sort(rows, {}, &ModuliPoint::relative_density);
  for (std::size_t first = 0, end = 0; first < rows.size(); first = end) {
    ModuliPoint mean;
    for (; end < rows.size() &&
           rows[end].relative_density <=
               rows[first].relative_density * (1 + same_density);
         ++end) {
      mean.bulk_modulus += rows[end].bulk_modulus;
      mean.shear_modulus += rows[end].shear_modulus;
    }
    const auto count = static_cast<double>(end - first);
    mean.relative_density = rows[first].relative_density;
    mean.bulk_modulus /= count;
    mean.shear_modulus /= count;
    rows_.push_back(mean);
  }
}

ModuliPoint PathElasticity::at(double relative_density) const
{
  if (rows_.size() == 1)
    return rows_.front();
  auto above = std::ranges::upper_bound(
      rows_, relative_density, {}, &ModuliPoint::relative_density);
  above = std::clamp(above, rows_.begin() + 1, rows_.end() - 1);
  const ModuliPoint &a = *(above - 1), &b = *above;
  ModuliPoint result;
  result.relative_density = relative_density;
  result.bulk_modulus = power(relative_density,
                              a.relative_density,
                              a.bulk_modulus,
                              b.relative_density,
                              b.bulk_modulus);
  result.shear_modulus = power(relative_density,
                               a.relative_density,
                               a.shear_modulus,
                               b.relative_density,
                               b.shear_modulus);
  return result;
}

PlasticPath::PlasticPath(const ProbeData &probe,
                         const PathElasticity &elasticity)
    : elasticity_(elasticity)
{
  double log_density = 0, before = 0, density_before = 0;
  for (const PathPoint &state : probe.curve) {
    const double density = state.relative_density;
    const double middle =
        points_.empty() ? density : std::sqrt(density * density_before);
    const double compaction = points_.empty()
                                  ? std::log(density)
                                  : std::log(density / density_before);
    // Moduli half-way through the increment.
    double elastic = 0;
    for (unsigned i = 0; i < 2; ++i) {
      const double unloaded =
          points_.empty() ? density * std::exp(-elastic)
                          : std::exp(log_density + (compaction - elastic) / 2);
      elastic = (state.pressure - before) /
                elasticity_.at(middle, unloaded).bulk_modulus;
    }
    log_density += compaction - elastic;
    points_.push_back({std::exp(log_density), state});
    // A powder that has not yielded yet must not seem to become looser.
    if (points_.size() > 1)
      points_.back().density =
          std::max(points_.back().density, points_[points_.size() - 2].density);
    before = state.pressure;
    density_before = density;
  }
}

std::vector<PlasticPath::Point> PlasticPath::yielded(double offset) const
{
  std::vector<Point> result;
  for (const Point &point : points_)
    if (std::log(point.density / points_.front().density) > offset &&
        (result.empty() || point.density > result.back().density))
      result.push_back(point);
  return result;
}

double PlasticPath::unloaded(double relative_density) const
{
  return interpolated(
      points_,
      relative_density,
      [](const Point &point) { return point.state.relative_density; },
      [](const Point &point) { return point.density; });
}

double PlasticPath::loaded(double density) const
{
  return interpolated(
      points_,
      density,
      [](const Point &point) { return point.density; },
      [](const Point &point) { return point.state.relative_density; });
}

double PlasticPath::pressure(double density) const
{
  return interpolated(
      points_,
      density,
      [](const Point &point) { return point.density; },
      [](const Point &point) { return point.state.pressure; });
}

PathSlope PlasticPath::slope(double density, double reach) const
{
  const double centre = loaded(density);
  std::vector<std::pair<double, const PathPoint *>> near;
  for (const Point &point : points_)
    near.emplace_back(std::log(point.state.relative_density / centre),
                      &point.state);
  std::ranges::stable_sort(
      near, {}, [](const auto &item) { return std::abs(item.first); });
  std::size_t count = std::min<std::size_t>(7, near.size());
  while (count < near.size() && std::abs(near[count].first) <= reach)
    ++count;
  Eigen::MatrixXd powers(count, 3), stresses(count, 2);
  const double width = std::abs(near[count - 1].first);
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double x = near[i].first / width;
    powers.row(row) << 1, x, x * x;
    stresses.row(row) << near[i].second->pressure,
        near[i].second->deviatoric_stress;
  }
  const Eigen::MatrixXd fit = powers.colPivHouseholderQr().solve(stresses);
  const ModuliPoint moduli = elasticity_.at(centre, density);
  // Shares of the increment d ln D, which is the axial strain, too.
  const double compaction = 1 - fit(1, 0) / width / moduli.bulk_modulus;
  const double shear = 2. / 3 - fit(1, 1) / width / (3 * moduli.shear_modulus);
  return {fit(0, 0), fit(0, 1), compaction / shear};
}

std::vector<ModuliPoint> unloaded_moduli(const ProbeData &probe)
{
  if (probe.moduli.empty())
    return {};
  // Elastic strains are small: each repetition is nearer by a multiple.
  constexpr unsigned repetitions = 8;
  std::vector<ModuliPoint> rows = probe.moduli;
  for (unsigned i = 0; i < repetitions; ++i) {
    const PlasticPath path(probe, PathElasticity(rows, i > 0));
    for (std::size_t k = 0; k < rows.size(); ++k)
      rows[k].relative_density =
          path.unloaded(probe.moduli[k].relative_density);
  }
  return rows;
}
} // namespace tamp::apps
