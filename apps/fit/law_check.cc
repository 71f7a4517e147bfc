// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/law_check.h>
#include <apps/input/start_density.h>
#include <apps/output/scatter.h>
#include <fem/path_driver.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tamp::apps
{
namespace
{
constexpr unsigned compared_densities = 60;
constexpr unsigned compared_stresses = 60;
constexpr double increment = 2e-3; ///< largest strain of one
constexpr double half = 0.5;       ///< of the peak: where slopes end

struct AxialState {
  double relative_density, strain, stress, lateral;
};

// Loading and unloading of the law.
struct Driven {
  std::vector<AxialState> loading, unloading;
  bool complete = false;
};

// @param share  of the peak to which it is unloaded; 1: it is not
Driven drive(const coupling::MaterialChoice &law, double density, double share)
{
  const double strain = std::log(density / start_density(law).value());
  std::vector<fem::PathStage> stages(share < 1 ? 2 : 1);
  stages[0].components[2].value = -strain;
  stages[0].maximum_increment = increment;
  if (share < 1) {
    stages[1].components[2].value = 0;
    stages[1].has_until = true;
    stages[1].maximum_increment = increment / 20;
  }
  Driven driven;
  const auto material = coupling::make_material(law, 1);
  const fem::PathEnd end = fem::drive_path(
      *material.points,
      stages,
      [&](unsigned stage) {
        if (stage == 1)
          stages[1].until_stress = -share * driven.loading.back().stress;
      },
      [&](const fem::PathRecord &record) {
        const AxialState state{record.response.relative_density,
                               -std::log(record.F[2][2]),
                               -record.response.stress[2][2],
                               -record.response.stress[0][0]};
        (record.stage == 0 ? driven.loading : driven.unloading)
            .push_back(state);
      });
  driven.complete = end == fem::PathEnd::finished;
  return driven;
}

// Linear in x, which increases, constant beyond the ends.
template <class States, class X, class Y>
double interpolated(const States &states, double at, X x, Y y)
{
  const auto above = std::ranges::upper_bound(states, at, {}, x);
  if (above == states.begin())
    return y(states.front());
  if (above == states.end())
    return y(states.back());
  const auto &low = *(above - 1), &high = *above;
  const double share = (at - x(low)) / (x(high) - x(low));
  return (1 - share) * y(low) + share * y(high);
}

double stress_at(const std::vector<AxialState> &states, double density)
{
  const auto x = [](const AxialState &state) { return state.relative_density; };
  const auto y = [](const AxialState &state) { return state.stress; };
  return interpolated(states, density, x, y);
}

// Slope from the peak to its half.
double slope_of(const std::vector<AxialState> &unloading)
{
  const AxialState &peak = unloading.front();
  const AxialState *end = nullptr;
  for (const AxialState &state : unloading)
    if (state.stress >= 0.998 * half * peak.stress)
      end = &state;
  return end && end->strain < peak.strain
             ? (peak.stress - end->stress) / (peak.strain - end->strain)
             : 0;
}

std::vector<AxialState> axial_states(const std::vector<PathPoint> &points)
{
  std::vector<AxialState> states;
  for (const PathPoint &point : points)
    states.push_back({point.relative_density,
                      point.axial_strain,
                      point.axial_stress,
                      (3 * point.pressure - point.axial_stress) / 2});
  return states;
}

// What it is where the axial stress has fallen to a share of its first value.
UnloadingState state_at(const std::vector<AxialState> &unloading, double share)
{
  const AxialState &peak = unloading.front();
  const auto x = [](const AxialState &state) { return -state.stress; };
  const auto read = [&](double AxialState::*y) {
    return interpolated(unloading,
                        -share * peak.stress,
                        x,
                        [y](const AxialState &state) { return state.*y; });
  };
  return {peak.strain - read(&AxialState::strain), read(&AxialState::lateral)};
}

/// The uniaxial probes, loaded and unloaded.
struct UniaxialData {
  std::vector<std::vector<AxialState>> loading;
  std::vector<std::vector<AxialState>> unloading; ///< of those that are
  double densest = 0;
  double share = half; ///< of their peaks to which all of these go

  explicit UniaxialData(const std::vector<ProbeData> &probes)
  {
    double least = 0;
    for (const ProbeData &probe : probes) {
      if (probe.loading != Loading::uniaxial)
        continue;
      loading.push_back(axial_states(probe.curve));
      densest = std::max(densest, probe.curve.back().relative_density);
      if (probe.unloading.size() < 2)
        continue;
      unloading.push_back(axial_states(probe.unloading));
      const auto &states = unloading.back();
      least = std::max(least, states.back().stress / states.front().stress);
    }
    if (!unloading.empty())
      share = least;
  }
};

void compare_loading(const Driven &driven,
                     const UniaxialData &data,
                     const std::vector<Driven> &replicas,
                     const std::array<double, 2> &range,
                     LawCheck &check)
{
  for (unsigned i = 0; i < compared_densities; ++i) {
    CheckRow row;
    const double density =
        range[0] + (range[1] - range[0]) * i / (compared_densities - 1);
    row.relative_density = density;
    std::vector<double> stresses;
    for (const auto &states : data.loading)
      stresses.push_back(stress_at(states, density));
    const Scatter scatter = scatter_of(stresses);
    row.data = scatter.mean;
    row.deviation = scatter.deviation;
    row.law = row.lowest = row.highest = stress_at(driven.loading, density);
    for (const Driven &replica : replicas) {
      const double stress = stress_at(replica.loading, density);
      row.lowest = std::min(row.lowest, stress);
      row.highest = std::max(row.highest, stress);
    }
    const double difference = std::abs(row.law / row.data - 1);
    check.mean_difference += difference / compared_densities;
    if (difference > check.worst_difference) {
      check.worst_difference = difference;
      check.worst_density = density;
    }
    check.rows.push_back(row);
  }
}

void compare_unloading(const std::vector<AxialState> &law,
                       const UniaxialData &data,
                       LawCheck &check)
{
  const auto count = static_cast<double>(data.unloading.size());
  check.law_peak = law.front().stress;
  for (const auto &states : data.unloading) {
    check.data_peak += states.front().stress / count;
    check.data_slope += slope_of(states) / count;
  }
  for (unsigned i = 0; i < compared_stresses; ++i) {
    UnloadingRow row;
    row.share = 1 - (1 - data.share) * i / (compared_stresses - 1);
    row.law = state_at(law, row.share);
    for (const auto &states : data.unloading) {
      const UnloadingState state = state_at(states, row.share);
      row.data.recovered += state.recovered / count;
      row.data.lateral += state.lateral / count;
    }
    check.unloading.push_back(row);
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
                   double last_density,
                   const std::vector<coupling::MaterialChoice> &replicas)
{
  const UniaxialData data(probes);
  LawCheck check;
  if (data.loading.empty())
    return check;
  Driven driven = drive(law, data.densest, std::min(half, data.share));
  check.complete = driven.complete;
  if (driven.loading.size() < 2)
    return check;
  std::vector<Driven> others;
  for (const coupling::MaterialChoice &replica : replicas)
    if (Driven other = drive(replica, last_density, 1);
        other.loading.size() > 1)
      others.push_back(std::move(other));
  compare_loading(driven, data, others, {first_density, last_density}, check);
  auto &unloading = driven.unloading;
  unloading.insert(unloading.begin(), driven.loading.back());
  check.law_slope = slope_of(unloading);
  if (!data.unloading.empty())
    compare_unloading(unloading, data, check);
  return check;
}
} // namespace tamp::apps
