// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/compared_curves.h>

#include <algorithm>
#include <cmath>

namespace tamp::apps
{
namespace
{
std::vector<CurvePair> die_pairs()
{
  const std::vector<std::string> pressing{"press", "unload"};
  std::vector<CurvePair> pairs;
  for (const char *abscissa : {"mean_relative_density[-]", "approach[m]"})
    for (const char *ordinate :
         {"upper_pressure[Pa]", "lower_pressure[Pa]", "wall_pressure[Pa]"})
      pairs.push_back({ordinate, abscissa, pressing});
  pairs.push_back({"wall_friction_force[N]", "approach[m]", pressing});
  pairs.push_back({"density_range[-]", "mean_relative_density[-]", pressing});
  pairs.push_back({"lower_force[N]", "travel[m]", {"eject"}});
  pairs.push_back({"wall_friction_force[N]", "travel[m]", {"eject"}});
  return pairs;
}

// The line before the first ejection.
std::size_t begin_of_ejection(const ResultCurve &curve)
{
  for (const StageLines &lines : curve.stages())
    if (curve.kind(lines.stage) == "eject")
      return lines.first;
  return 0;
}

void add_die_columns(ResultCurve &curve)
{
  const auto &upper = curve.column("upper_displacement[m]");
  const auto &lower = curve.column("lower_displacement[m]");
  const auto &largest = curve.column("maximum_relative_density[-]");
  const auto &smallest = curve.column("minimum_relative_density[-]");
  const std::size_t begin = begin_of_ejection(curve);
  const auto lift = [&](std::size_t i) {
    return lower[i] - curve.column("die_displacement[m]")[i];
  };
  std::vector<double> approach, travel, range;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    approach.push_back(upper[i] + lower[i]);
    travel.push_back(lift(i) - lift(begin));
    range.push_back(largest[i] - smallest[i]);
  }
  curve.add("approach[m]", approach);
  curve.add("travel[m]", travel);
  curve.add("density_range[-]", range);
}

PlainCurve part_of(const ResultCurve &curve,
                   const StageLines &lines,
                   const CurvePair &pair)
{
  const auto slice = [&](const std::string &name) {
    const auto &values = curve.column(name);
    return std::vector<double>(
        values.begin() + static_cast<std::ptrdiff_t>(lines.first),
        values.begin() + static_cast<std::ptrdiff_t>(lines.last + 1));
  };
  std::vector<double> x = slice(pair.abscissa);
  if (pair.logarithmic)
    for (double &value : x)
      value = value > 0 ? std::log(value) : std::nan("");
  return monotone_part(x, slice(pair.ordinate));
}

std::optional<CurveDifference> difference(const ResultFolder &reference,
                                          const ResultFolder &other,
                                          std::size_t stage,
                                          const CurvePair &pair)
{
  for (const ResultFolder *run : {&reference, &other})
    if (!run->curve.has(pair.abscissa) || !run->curve.has(pair.ordinate))
      return {};
  auto result = difference_of(
      part_of(reference.curve, reference.curve.stages()[stage], pair),
      part_of(other.curve, other.curve.stages()[stage], pair));
  if (result && pair.logarithmic)
    for (double *x : {&result->from, &result->to, &result->at})
      *x = std::exp(*x);
  return result;
}
} // namespace

std::vector<CurvePair> curve_pairs(const std::string &command)
{
  if (command == "die")
    return die_pairs();
  if (command == "probe")
    return {{"stress_zz[Pa]", "strain_zz[-]"},
            {"lateral_stress[Pa]", "strain_zz[-]"},
            {"lateral_stress[Pa]", "stress_zz[Pa]"},
            {"deviatoric_stress[Pa]", "pressure[Pa]"},
            {"relative_density[-]", "pressure[Pa]", {}, true},
            {"coordination_number[-]", "relative_density[-]"}};
  if (command == "pack")
    return {{"axial_stress[Pa]", "relative_density[-]"},
            {"lateral_stress[Pa]", "relative_density[-]"},
            {"mechanical_coordination_number[-]", "relative_density[-]"}};
  return {{"normal_force[N]", "overlap[m]"},
          {"tangential_force_x[N]", "slip_x[m]"},
          {"normal_force[N]", "time[s]"},
          {"tangential_force_x[N]", "time[s]"}};
}

void add_derived_columns(ResultFolder &run)
{
  ResultCurve &curve = run.curve;
  if (run.command == "die")
    add_die_columns(curve);
  if (run.command == "probe") {
    std::vector<double> lateral;
    for (std::size_t i = 0; i < curve.size(); ++i)
      lateral.push_back(0.5 * (curve.column("stress_xx[Pa]")[i] +
                               curve.column("stress_yy[Pa]")[i]));
    curve.add("lateral_stress[Pa]", lateral);
  }
}

std::size_t common_stages(std::span<const ResultFolder> runs)
{
  const ResultCurve &reference = runs.front().curve;
  std::size_t count = reference.stages().size();
  for (const ResultFolder &run : runs.subspan(1)) {
    const auto &stages = run.curve.stages();
    std::size_t same = 0;
    while (same < std::min(count, stages.size()) &&
           stages[same].stage == reference.stages()[same].stage &&
           run.curve.kind(stages[same].stage) ==
               reference.kind(stages[same].stage))
      ++same;
    count = same;
  }
  return count;
}

std::vector<StageDifference> compare_curves(std::span<const ResultFolder> runs)
{
  std::vector<StageDifference> all;
  const ResultCurve &reference = runs.front().curve;
  const std::size_t stages = common_stages(runs);
  for (std::size_t stage = 0; stage < stages; ++stage) {
    const unsigned number = reference.stages()[stage].stage;
    const std::string kind = reference.kind(number);
    for (const CurvePair &pair : curve_pairs(runs.front().command)) {
      if (!pair.kinds.empty() && !std::ranges::count(pair.kinds, kind))
        continue;
      StageDifference result{pair, number, kind, {std::nullopt}};
      for (const ResultFolder &run : runs.subspan(1))
        result.of_run.push_back(difference(runs.front(), run, stage, pair));
      if (std::ranges::any_of(result.of_run, [](const auto &difference) {
            return difference.has_value();
          }))
        all.push_back(std::move(result));
    }
  }
  return all;
}
} // namespace tamp::apps
