// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/cap_samples.h>
#include <apps/input/units.h>
#include <apps/output/scatter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <set>

namespace tamp::apps
{
namespace
{
constexpr std::array<double CapValues::*, 6> all_values{
    &CapValues::cohesion,
    &CapValues::friction_angle,
    &CapValues::eccentricity,
    &CapValues::yield_pressure,
    &CapValues::youngs_modulus,
    &CapValues::poissons_ratio};

bool at(const SampleLevel &level, double density)
{
  return std::abs(density - level.density) <= level.half_width;
}

// What folders without moduli of their own use: those of the others, over the
// unloaded density.
PathElasticity common_elasticity(const std::vector<ProbeData> &probes)
{
  std::vector<ModuliPoint> rows;
  for (const ProbeData &probe : probes) {
    const auto own = unloaded_moduli(probe);
    rows.insert(rows.end(), own.begin(), own.end());
  }
  if (!rows.empty())
    return PathElasticity(rows, true);
  for (const ProbeData &probe : probes)
    if (const ModuliPoint row = moduli_of_unloading(probe);
        row.bulk_modulus > 0 && row.shear_modulus > 0)
      rows.push_back(row);
  if (rows.empty())
    throw InputError(
        "no elastic moduli: no folder has a moduli.csv, nor a uniaxial path "
        "that is unloaded; expected Scan/Densities in the input of the probe");
  return PathElasticity(rows);
}

void check_loadings(const std::vector<ProbeData> &probes)
{
  if (std::ranges::none_of(probes, [](const ProbeData &probe) {
        return probe.loading == Loading::uniaxial;
      }))
    throw InputError(fmt::format(
        "the cap needs a uniaxial probe for its eccentricity; '{}'{} isotropic",
        probes.front().folder.string(),
        probes.size() > 1 ? " and all others are" : " is"));
  if (std::ranges::all_of(
          probes, [](const ProbeData &probe) { return probe.yields.empty(); }))
    throw InputError(fmt::format(
        "there is no yield.csv in '{}'{}; expected at least one probe that was "
        "run with Scan/Densities",
        probes.front().folder.string(),
        probes.size() > 1 ? " nor in the other folders" : ""));
}
} // namespace

CapSamples::CapSamples(const std::vector<ProbeData> &probes,
                       YieldCriterion criterion)
    : criterion_(criterion)
{
  check_loadings(probes);
  const PathElasticity common = common_elasticity(probes);
  std::array<std::size_t, 2> ordinals{};
  for (const ProbeData &probe : probes) {
    has_moduli_ |= !probe.moduli.empty();
    const PathElasticity elasticity =
        probe.moduli.empty() ? common
                             : PathElasticity(unloaded_moduli(probe), true);
    probes_.push_back({&probe,
                       ordinals[static_cast<std::size_t>(probe.loading)]++,
                       elasticity,
                       PlasticPath(probe, elasticity)});
  }
}

std::vector<const PlasticPath *> CapSamples::paths(Loading loading) const
{
  std::vector<const PlasticPath *> result;
  for (const Probe &probe : probes_)
    if (probe.data->loading == loading)
      result.push_back(&probe.path);
  return result;
}

std::vector<SampleLevel> CapSamples::levels() const
{
  // Densities of one replica in one folder are different levels; those of
  // different ones that are nearer than half of that are the same.
  std::set<double> all;
  double gap = 1;
  for (const Probe &probe : probes_) {
    std::map<int, std::set<double>> of_replica;
    for (const YieldPoint &point : probe.data->yields)
      of_replica[point.replica].insert(
          probe.path.unloaded(point.relative_density));
    for (const auto &[number, densities] : of_replica) {
      all.insert(densities.begin(), densities.end());
      for (auto next = densities.begin(); next != densities.end();)
        if (const double first = *next++; next != densities.end())
          gap = std::min(gap, *next - first);
    }
  }
  std::vector<SampleLevel> result;
  for (auto begin = all.begin(); begin != all.end();) {
    const auto end = all.upper_bound(*begin + gap / 2);
    const double low = *begin, high = *std::prev(end);
    result.push_back({(low + high) / 2, (high - low) / 2 + 1e-9});
    begin = end;
  }
  return result;
}

std::vector<CapSamples::Replica> CapSamples::replicas() const
{
  std::set<Replica> all;
  for (const Probe &probe : probes_)
    for (const YieldPoint &point : probe.data->yields)
      all.insert({probe.ordinal, point.replica});
  return {all.begin(), all.end()};
}

const CapSamples::Probe &CapSamples::uniaxial_of(const Replica &replica) const
{
  const Probe *found = nullptr;
  for (const Probe &probe : probes_)
    if (probe.data->loading == Loading::uniaxial &&
        (!found || probe.ordinal == replica.first))
      found = &probe;
  return *found;
}

std::vector<StressPoint> CapSamples::points_of(const Replica &replica,
                                               const SampleLevel &level,
                                               YieldCriterion criterion) const
{
  std::vector<StressPoint> points;
  for (const Probe &probe : probes_)
    for (const YieldPoint &point : probe.data->yields)
      if (Replica(probe.ordinal, point.replica) == replica &&
          point.criterion == static_cast<int>(criterion) &&
          point.deviatoric_stress > 0 && point.pressure > 0 &&
          at(level, probe.path.unloaded(point.relative_density)))
        points.push_back({point.pressure, point.deviatoric_stress});
  std::ranges::stable_sort(points, {}, &StressPoint::p);
  return points;
}

// Shear points are those below the centre of the cap that they lead to. First
// guess: those of the two lowest pressures, as one alone tells no cohesion.
bool CapSamples::divide(const std::vector<StressPoint> &points,
                        Finding &finding) const
{
  const auto second = std::ranges::find_if(points, [&](const StressPoint &at) {
    return at.p > 1.1 * points.front().p;
  });
  double centre = second == points.end() ? points.back().p : second->p;
  std::size_t count = 0;
  for (unsigned round = 0; round < 20; ++round) {
    const auto end = std::ranges::upper_bound(
        points, centre * (1 + 1e-9), {}, &StressPoint::p);
    const auto now = static_cast<std::size_t>(end - points.begin());
    if (now == 0 || (round > 0 && now == count))
      break;
    count = now;
    finding.line = fit_shear_line({points.begin(), points.begin() + count});
    const auto cap =
        cap_by_flow(finding.line, finding.uniaxial, finding.plastic_ratio);
    if (!cap || !(finding.line.slope > 0))
      return false;
    centre = std::max(cap->centre, points.front().p);
    finding.values.eccentricity = cap->eccentricity;
    finding.values.yield_pressure = cap->yield_pressure;
  }
  const auto middle = points.begin() + static_cast<std::ptrdiff_t>(count);
  finding.shear_points.assign(points.begin(), middle);
  finding.cap_points.assign(middle, points.end());
  return true;
}

void CapSamples::take_moduli(const Replica &replica,
                             const SampleLevel &level,
                             CapValues &values) const
{
  const Probe *probe = &uniaxial_of(replica);
  std::vector<ModuliPoint> rows;
  for (const Probe &other : probes_)
    if (rows.empty() && other.ordinal == replica.first) {
      std::ranges::copy_if(other.data->moduli,
                           std::back_inserter(rows),
                           [&](const ModuliPoint &row) {
                             return row.replica == replica.second;
                           });
      if (!rows.empty())
        probe = &other;
    }
  const double loaded = probe->path.loaded(level.density);
  const ModuliPoint found = rows.empty()
                                ? probe->elasticity.at(loaded, level.density)
                                : PathElasticity(rows).at(loaded);
  const double K = found.bulk_modulus, G = found.shear_modulus;
  values.youngs_modulus = 9 * K * G / (3 * K + G);
  values.poissons_ratio = (3 * K - 2 * G) / (2 * (3 * K + G));
}

std::optional<CapSamples::Finding>
CapSamples::find(const Replica &replica, const SampleLevel &level) const
{
  const auto points = points_of(replica, level, criterion_);
  const Probe &probe = uniaxial_of(replica);
  const auto yielded = probe.path.yielded(yield_offset);
  if (points.empty() || yielded.empty() ||
      level.density < yielded.front().density ||
      level.density > probe.path.last_density() + level.half_width)
    return {};
  Finding finding;
  const PathSlope slope = probe.path.slope(level.density);
  finding.plastic_ratio = slope.plastic_ratio;
  std::vector<double> p, q;
  for (const YieldPoint &point : probe.data->yields)
    if (point.replica == replica.second &&
        at(level, probe.path.unloaded(point.relative_density))) {
      p.push_back(point.reached_pressure);
      q.push_back(point.reached_deviator);
    }
  finding.uniaxial = p.empty()
                         ? StressPoint{slope.pressure, slope.deviatoric_stress}
                         : StressPoint{scatter_of(p).mean, scatter_of(q).mean};
  if (!divide(points, finding))
    return {};
  finding.values.cohesion = finding.line.cohesion;
  finding.values.friction_angle = std::atan(finding.line.slope);
  finding.rigid_eccentricity =
      cap_by_flow(finding.line, finding.uniaxial, 1.5)->eccentricity;
  take_moduli(replica, level, finding.values);
  return finding;
}

std::pair<double, double> CapSamples::elasticity(double density) const
{
  std::vector<double> young, poisson;
  for (const Probe &probe : probes_) {
    if (probe.data->loading != Loading::uniaxial)
      continue;
    const ModuliPoint found =
        probe.elasticity.at(probe.path.loaded(density), density);
    const double K = found.bulk_modulus, G = found.shear_modulus;
    young.push_back(9 * K * G / (3 * K + G));
    poisson.push_back((3 * K - 2 * G) / (2 * (3 * K + G)));
  }
  return {scatter_of(young).mean, scatter_of(poisson).mean};
}

double CapSamples::angle_by(YieldCriterion criterion,
                            const SampleLevel &level) const
{
  std::vector<double> angles;
  for (const Replica &replica : replicas()) {
    const auto points = points_of(replica, level, criterion);
    Finding finding;
    if (points.empty())
      continue;
    const PathSlope slope = uniaxial_of(replica).path.slope(level.density);
    finding.uniaxial = {slope.pressure, slope.deviatoric_stress};
    finding.plastic_ratio = slope.plastic_ratio;
    if (divide(points, finding))
      angles.push_back(std::atan(finding.line.slope));
  }
  return scatter_of(angles).mean;
}

std::optional<CapLevel> CapSamples::fit(const SampleLevel &level)
{
  std::vector<Finding> findings;
  for (const Replica &replica : replicas())
    if (const auto finding = find(replica, level)) {
      findings.push_back(*finding);
      origin_lines_ += finding->line.through_origin;
    }
  if (findings.empty())
    return {};
  const auto spread = [&](const auto &value) {
    std::vector<double> values;
    for (const Finding &finding : findings)
      values.push_back(value(finding));
    return scatter_of(values);
  };
  CapLevel result;
  result.density = level.density;
  result.loaded_density = uniaxial_of({0, 0}).path.loaded(level.density);
  result.replicas = static_cast<unsigned>(findings.size());
  for (const auto field : all_values) {
    const Scatter found =
        spread([&](const Finding &finding) { return finding.values.*field; });
    result.mean.*field = result.value.*field = found.mean;
    result.deviation.*field = found.deviation;
  }
  result.uniaxial_yield_pressure = result.mean.yield_pressure;
  result.plastic_ratio =
      spread([](const Finding &finding) { return finding.plastic_ratio; }).mean;
  result.rigid_eccentricity = spread([](const Finding &finding) {
                                return finding.rigid_eccentricity;
                              }).mean;
  result.uniaxial = {
      spread([](const Finding &finding) { return finding.uniaxial.p; }).mean,
      spread([](const Finding &finding) { return finding.uniaxial.q; }).mean};
  for (const Finding &finding : findings) {
    result.shear_points.insert(result.shear_points.end(),
                               finding.shear_points.begin(),
                               finding.shear_points.end());
    result.cap_points.insert(result.cap_points.end(),
                             finding.cap_points.begin(),
                             finding.cap_points.end());
  }
  for (const auto criterion :
       {YieldCriterion::strain, YieldCriterion::work, YieldCriterion::peak})
    result.angle_by_criterion[static_cast<std::size_t>(criterion)] =
        angle_by(criterion, level);
  return result;
}

void CapSamples::take_yield_pressure(Loading from,
                                     const std::function<double(double)> &table,
                                     CapLevel &level) const
{
  if (from == Loading::uniaxial)
    return; // what fit() has found
  std::map<Replica, std::vector<double>> found;
  for (const Probe &probe : probes_) {
    if (probe.data->loading != from)
      continue;
    if (probe.data->yields.empty())
      found[{probe.ordinal, 0}].push_back(probe.path.pressure(level.density));
    for (const YieldPoint &point : probe.data->yields) {
      const double density = probe.path.unloaded(point.relative_density);
      if (std::abs(std::log(density / level.density)) < 0.02)
        found[{probe.ordinal, point.replica}].push_back(
            point.reached_pressure * table(level.density) / table(density));
    }
  }
  std::vector<double> values;
  for (const auto &[replica, pressures] : found)
    values.push_back(scatter_of(pressures).mean);
  if (values.empty())
    return;
  const Scatter spread = scatter_of(values);
  level.mean.yield_pressure = spread.mean;
  level.deviation.yield_pressure = spread.deviation;
}
} // namespace tamp::apps
