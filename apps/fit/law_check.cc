// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/law_check.h>
#include <apps/input/units.h>
#include <fem/path_driver.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tamp::apps
{
namespace
{
constexpr unsigned compared_densities = 60;
constexpr double increment = 2e-3; ///< largest strain of one

struct AxialState {
  double relative_density, strain, stress;
};

// Loading and unloading of the law.
struct Driven {
  std::vector<AxialState> loading, unloading;
  bool complete = false;
};

double initial_density(const coupling::MaterialChoice &law)
{
  switch (law.kind) {
  case coupling::MaterialKind::drucker_prager_cap:
    return law.cap.initial_relative_density;
  case coupling::MaterialKind::modified_cam_clay:
    return law.cam_clay.initial_relative_density;
  case coupling::MaterialKind::fkm_gurson:
    return law.fkm_gurson.initial_relative_density;
  default:
    throw InputError("expected a continuum law that fits give");
  }
}

Driven drive(const coupling::MaterialChoice &law, double density)
{
  const double start = initial_density(law), strain = std::log(density / start);
  std::vector<fem::PathStage> stages(2);
  stages[0].components[2].value = -strain;
  stages[1].components[2].value = 0;
  stages[1].has_until = true;
  for (fem::PathStage &stage : stages)
    stage.maximum_increment = increment;
  stages[1].maximum_increment = increment / 20;
  Driven driven;
  const auto material = coupling::make_material(law, 1);
  const fem::PathEnd end = fem::drive_path(
      *material.points,
      stages,
      [&](unsigned stage) {
        if (stage == 1)
          stages[1].until_stress = -0.5 * driven.loading.back().stress;
      },
      [&](const fem::PathRecord &record) {
        const AxialState state{record.response.relative_density,
                               -std::log(record.F[2][2]),
                               -record.response.stress[2][2]};
        (record.stage == 0 ? driven.loading : driven.unloading)
            .push_back(state);
      });
  driven.complete = end == fem::PathEnd::finished;
  return driven;
}

template <class Points, class Stress>
double stress_at(const Points &points, double density, Stress stress)
{
  const auto above = std::ranges::upper_bound(
      points, density, {}, [](const auto &p) { return p.relative_density; });
  if (above == points.begin())
    return stress(points.front());
  if (above == points.end())
    return stress(points.back());
  const auto &low = *(above - 1), &high = *above;
  const double share = (density - low.relative_density) /
                       (high.relative_density - low.relative_density);
  return (1 - share) * stress(low) + share * stress(high);
}

// Slope from the peak to its half.
double slope_of(double peak_stress,
                double peak_strain,
                const std::vector<AxialState> &unloading)
{
  const AxialState *end = nullptr;
  for (const AxialState &state : unloading)
    if (state.stress >= 0.499 * peak_stress)
      end = &state;
  return end && end->strain < peak_strain
             ? (peak_stress - end->stress) / (peak_strain - end->strain)
             : 0;
}

double slope_of(const ProbeData &probe)
{
  std::vector<AxialState> states;
  for (const PathPoint &point : probe.unloading)
    states.push_back(
        {point.relative_density, point.axial_strain, point.axial_stress});
  return slope_of(states.front().stress, states.front().strain, states);
}

void compare(const Driven &driven,
             const std::vector<const ProbeData *> &data,
             const std::array<double, 2> &range,
             LawCheck &check)
{
  for (unsigned i = 0; i < compared_densities; ++i) {
    CheckRow row;
    row.relative_density =
        range[0] + (range[1] - range[0]) * i / (compared_densities - 1);
    for (const ProbeData *probe : data)
      row.data += stress_at(probe->curve,
                            row.relative_density,
                            [](const PathPoint &p) { return p.axial_stress; }) /
                  static_cast<double>(data.size());
    row.law = stress_at(driven.loading,
                        row.relative_density,
                        [](const AxialState &state) { return state.stress; });
    const double difference = std::abs(row.law / row.data - 1);
    check.mean_difference += difference / compared_densities;
    if (difference > check.worst_difference) {
      check.worst_difference = difference;
      check.worst_density = row.relative_density;
    }
    check.rows.push_back(row);
  }
}
} // namespace

double LawCheck::slope_difference() const
{
  return data_slope > 0 && law_slope > 0 ? law_slope / data_slope - 1 : 0;
}

LawCheck check_law(const coupling::MaterialChoice &law,
                   const std::vector<ProbeData> &probes,
                   double first_density,
                   double last_density)
{
  std::vector<const ProbeData *> data;
  double densest = 0;
  for (const ProbeData &probe : probes)
    if (probe.loading == Loading::uniaxial) {
      data.push_back(&probe);
      densest = std::max(densest, probe.curve.back().relative_density);
    }
  LawCheck check;
  if (data.empty())
    return check;
  const Driven driven = drive(law, densest);
  check.complete = driven.complete;
  if (driven.loading.size() < 2)
    return check;
  compare(driven, data, {first_density, last_density}, check);
  check.law_slope = slope_of(driven.loading.back().stress,
                             driven.loading.back().strain,
                             driven.unloading);
  unsigned unloaded = 0;
  for (const ProbeData *probe : data)
    if (const double slope = slope_of(*probe); slope > 0) {
      check.data_slope += slope;
      ++unloaded;
    }
  if (unloaded > 0)
    check.data_slope /= unloaded;
  return check;
}
} // namespace tamp::apps
