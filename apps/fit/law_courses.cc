// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/law_courses.h>
#include <apps/input/units.h>

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace tamp::apps
{
namespace
{
constexpr unsigned stops_on_path = 24;
constexpr double same_density = 1e-9;

CourseStop &stop_at(Course &course, double density)
{
  auto place = std::ranges::lower_bound(
      course.stops, density - same_density, {}, &CourseStop::relative_density);
  if (place == course.stops.end() ||
      place->relative_density > density + same_density)
    place = course.stops.insert(place, {density, {}, {}, {}});
  return *place;
}

} // namespace

StressPoint stress_at(const ProbeData &probe, double density)
{
  const auto &curve = probe.curve;
  auto above = std::ranges::upper_bound(
      curve, density, {}, &PathPoint::relative_density);
  above = std::clamp(above, curve.begin() + 1, curve.end() - 1);
  const PathPoint &a = *(above - 1), &b = *above;
  const double share = (density - a.relative_density) /
                       (b.relative_density - a.relative_density);
  return {a.pressure + share * (b.pressure - a.pressure),
          a.deviatoric_stress +
              share * (b.deviatoric_stress - a.deviatoric_stress)};
}

Courses::Courses(const std::vector<ProbeData> &probes, YieldCriterion criterion)
    : probes_(probes), criterion_(criterion)
{
  std::set<double> densities;
  for (const ProbeData &probe : probes)
    for (const YieldPoint &point : probe.yields)
      densities.insert(point.relative_density);
  if (densities.empty())
    throw InputError(fmt::format(
        "there is no yield.csv in '{}'{}; expected at least one probe that "
        "was run with Scan/Densities",
        probes.front().folder.string(),
        probes.size() > 1 ? " nor in the other folders" : ""));
  if (densities.size() < 3)
    throw InputError(fmt::format("the law needs yield points at at least 3 "
                                 "relative densities; there are {}",
                                 densities.size()));
  first_ = *densities.begin();
  last_ = *densities.rbegin();
}

std::vector<ReplicaOfProbes> Courses::replicas() const
{
  std::set<ReplicaOfProbes> all;
  for (std::size_t i = 0; i < probes_.size(); ++i)
    for (const YieldPoint &point : probes_[i].yields)
      all.insert({ordinal(i), point.replica});
  return {all.begin(), all.end()};
}

std::vector<Course> Courses::courses(const ReplicaOfProbes *only) const
{
  std::vector<Course> result;
  for (std::size_t i = 0; i < probes_.size(); ++i)
    if (!only || ordinal(i) == only->first)
      result.push_back(course(probes_[i], only));
  return result;
}

std::size_t Courses::ordinal(std::size_t number) const
{
  std::size_t result = 0;
  for (std::size_t i = 0; i < number; ++i)
    result += probes_[i].loading == probes_[number].loading;
  return result;
}

Course Courses::course(const ProbeData &probe,
                       const ReplicaOfProbes *only) const
{
  Course result{probe.loading, {}};
  const double end = std::min(last_, probe.curve.back().relative_density);
  for (unsigned i = 0; i < stops_on_path; ++i) {
    const double density = first_ + (end - first_) * i / (stops_on_path - 1);
    stop_at(result, density).stress = stress_at(probe, density);
  }
  for (const YieldPoint &point : probe.yields)
    if (point.criterion == static_cast<int>(criterion_) &&
        point.deviatoric_stress > 0 && (!only || point.replica == only->second))
      stop_at(result, point.relative_density)
          .yields.push_back({point.pressure, point.deviatoric_stress});
  for (const ModuliPoint &row : probe.moduli)
    if (!only || row.replica == only->second)
      stop_at(result, row.relative_density).moduli.push_back(row);
  return result;
}
} // namespace tamp::apps
