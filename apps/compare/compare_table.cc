// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/compare_report.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
const double none = std::nan("");

// Of all runs by a function of one.
ComparedQuantity quantity(const std::vector<ResultFolder> &runs,
                          const std::string &name,
                          auto value)
{
  ComparedQuantity result{name, {}};
  for (const ResultFolder &run : runs)
    result.values.push_back(value(run));
  return result;
}

ComparedQuantity result_of(const std::vector<ResultFolder> &runs,
                           const std::string &name)
{
  return quantity(runs, name, [&](const ResultFolder &run) {
    return run.result(name).value_or(none);
  });
}

bool is_known(const ComparedQuantity &quantity)
{
  return std::ranges::any_of(quantity.values,
                             [](double value) { return !std::isnan(value); });
}

// What the runs differ by in curve.
ComparedQuantity norm(const std::string &name,
                      const StageDifference &curve,
                      double CurveDifference::*value,
                      double reference)
{
  ComparedQuantity result{name, {reference}};
  for (std::size_t run = 1; run < curve.of_run.size(); ++run)
    result.values.push_back(curve.of_run[run] ? (*curve.of_run[run]).*value
                                              : none);
  return result;
}

// What the runs differ by in a field.
ComparedQuantity norm(const std::string &name,
                      const ComparedState &state,
                      double reference,
                      auto value)
{
  ComparedQuantity result{name, {reference}};
  for (const FieldDifference &other : state.others)
    result.values.push_back(value(other));
  return result;
}

std::string unit_of_field(const std::string &field)
{
  return field == "relative_density" ? "[-]" : "[Pa]";
}

std::string unit_of(const std::string &column)
{
  return column.substr(column.find('['));
}
} // namespace

std::vector<ComparedQuantity> key_results(const std::vector<ResultFolder> &runs)
{
  std::vector<ComparedQuantity> all;
  const auto add = [&](const std::string &name) {
    if (std::ranges::count(all, name, &ComparedQuantity::name) == 0)
      all.push_back(result_of(runs, name));
  };
  for (const ResultFolder &run : runs)
    for (const auto &[name, value] : run.results)
      if (!name.starts_with("time_"))
        add(name);
  ComparedQuantity range =
      quantity(runs, "density_range_at_peak[-]", [](const ResultFolder &run) {
        return run.result("maximum_relative_density_at_peak[-]")
                   .value_or(none) -
               run.result("minimum_relative_density_at_peak[-]").value_or(none);
      });
  const auto after = std::ranges::find(
      all, "maximum_relative_density_at_peak[-]", &ComparedQuantity::name);
  if (is_known(range))
    all.insert(after + 1, std::move(range));
  return all;
}

std::vector<ComparedQuantity> costs(const std::vector<ResultFolder> &runs)
{
  using Run = ResultFolder;
  std::vector<ComparedQuantity> all{
      quantity(
          runs, "cpu_time[s]", [](const Run &run) { return run.cpu_time; }),
      quantity(
          runs, "wall_time[s]", [](const Run &run) { return run.wall_time; }),
      quantity(runs, "ranks[-]", [](const Run &run) { return run.ranks; }),
      quantity(runs, "threads[-]", [](const Run &run) { return run.threads; })};
  ComparedQuantity updates =
      quantity(runs, "cell_updates[-]", [](const ResultFolder &run) {
        return run.result("cell_updates_per_step[-]").value_or(none) *
               run.result("steps[-]").value_or(none);
      });
  if (is_known(updates))
    all.insert(all.begin(), std::move(updates));
  return all;
}

std::vector<ComparedQuantity>
curve_norms(const std::vector<StageDifference> &curves)
{
  std::vector<ComparedQuantity> all;
  for (const StageDifference &curve : curves) {
    const std::string words =
        fmt::format("{} over {} in stage {}{}: ",
                    curve.pair.ordinate,
                    curve.pair.abscissa,
                    curve.stage,
                    curve.kind.empty() ? "" : " (" + curve.kind + ")");
    const std::string unit = unit_of(curve.pair.abscissa);
    all.push_back(norm(words + "relative_L2_difference[-]",
                       curve,
                       &CurveDifference::relative_L2,
                       0));
    all.push_back(norm(words + "largest_difference_over_largest_value[-]",
                       curve,
                       &CurveDifference::relative_largest,
                       0));
    all.push_back(
        norm(words + "largest_at" + unit, curve, &CurveDifference::at, none));
    all.push_back(
        norm(words + "from" + unit, curve, &CurveDifference::from, none));
    all.push_back(norm(words + "to" + unit, curve, &CurveDifference::to, none));
  }
  return all;
}

std::vector<ComparedQuantity>
field_norms(const std::vector<ComparedState> &states)
{
  std::vector<ComparedQuantity> all;
  for (const ComparedState &state : states) {
    const std::string when = state.state.name + "_";
    for (const auto &[field, values] : state.reference.values) {
      const auto add = [&](const std::string &what, double FieldNorm::*value) {
        all.push_back(norm(when + field + what + unit_of_field(field),
                           state,
                           0,
                           [&](const FieldDifference &other) {
                             const auto found = other.norms.find(field);
                             return found == other.norms.end()
                                        ? none
                                        : found->second.*value;
                           }));
      };
      add("_difference_mean", &FieldNorm::mean);
      add("_difference_root_mean_square", &FieldNorm::root_mean_square);
      add("_difference_largest", &FieldNorm::largest);
    }
    using Other = FieldDifference;
    all.push_back(
        norm(when + "points_outside[-]", state, 0, [](const Other &o) {
          return o.outside;
        }));
    all.push_back(norm(when + "solid_volume[m3]",
                       state,
                       state.reference_mass,
                       [](const Other &o) { return o.mass; }));
    all.push_back(norm(when + "solid_volume_difference_of_maps[m3]",
                       state,
                       0,
                       [](const Other &o) { return o.mass_difference; }));
  }
  return all;
}

std::string comparison_table(const Comparison &comparison)
{
  std::string text = fmt::format(
      "# tamp compare: runs of tamp {}; compression is positive; '{}' is the "
      "reference\n# name_difference has the unit of the quantity\nquantity",
      comparison.runs.front().command,
      comparison.runs.front().name);
  for (const ResultFolder &run : comparison.runs)
    text += "," + run.name;
  for (std::size_t run = 1; run < comparison.runs.size(); ++run)
    text += fmt::format(",{0}_difference,{0}_difference[%]",
                        comparison.runs[run].name);
  text += "\n";
  std::vector<ComparedQuantity> all = key_results(comparison.runs);
  for (const auto &more : {costs(comparison.runs),
                           curve_norms(comparison.curves),
                           field_norms(comparison.states)})
    all.insert(all.end(), more.begin(), more.end());
  for (const ComparedQuantity &quantity : all) {
    text += quantity.name;
    for (const double value : quantity.values)
      text += fmt::format(",{}", value);
    const double reference = quantity.values.front();
    for (std::size_t run = 1; run < quantity.values.size(); ++run) {
      const double difference = quantity.values[run] - reference;
      text += fmt::format(",{},{}",
                          difference,
                          std::abs(reference) > 0
                              ? 100 * difference / std::abs(reference)
                              : none);
    }
    text += "\n";
  }
  return text;
}
} // namespace tamp::apps
