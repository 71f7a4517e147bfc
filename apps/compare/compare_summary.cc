// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/compare_report.h>
#include <apps/run/run_folder.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
using Row = std::vector<std::string>;

// Letters of a word in UTF-8.
std::size_t width(const std::string &word)
{
  return static_cast<std::size_t>(std::ranges::count_if(
      word, [](char byte) { return (byte & 0xC0) != 0x80; }));
}

// The first column to the left, the others to the right.
std::string aligned(const std::vector<Row> &rows)
{
  std::vector<std::size_t> widths;
  for (const Row &row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], width(row[i]));
  }
  std::string text;
  for (const Row &row : rows) {
    std::string line = "  ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string gap(widths[i] - width(row[i]), ' ');
      line += i == 0 ? row[i] + gap : "   " + gap + row[i];
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string words_of(std::string name)
{
  name = name.substr(0, name.find('['));
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string said(const std::string &name, double value)
{
  return std::isnan(value) ? "-" : with_unit(name, value);
}

std::string per_cent(double share)
{
  if (std::isnan(share))
    return "-";
  const double value = 100 * share;
  return std::abs(value) < 0.005 && value != 0
             ? fmt::format("{:.1g} %", value)
             : fmt::format("{:.{}f} %", value, std::abs(value) < 1 ? 2 : 1);
}

// Of a value from that of the reference; none if that is zero.
std::string change(double value, double reference)
{
  if (std::isnan(value - reference) || !(std::abs(reference) > 0))
    return "-";
  const double change = 100 * (value - reference) / std::abs(reference);
  if (std::abs(change) < 0.005)
    return "0 %";
  return fmt::format("{:+.{}f} %", change, std::abs(change) < 10 ? 2 : 1);
}

std::string quantities(const Comparison &comparison,
                       const std::vector<ComparedQuantity> &all)
{
  std::vector<Row> rows(1, Row{""});
  for (const ResultFolder &run : comparison.runs) {
    rows.front().push_back(run.name);
    if (rows.front().size() > 2)
      rows.front().emplace_back("difference");
  }
  for (const ComparedQuantity &quantity : all) {
    Row &row = rows.emplace_back(Row{words_of(quantity.name)});
    for (const double value : quantity.values) {
      row.push_back(said(quantity.name, value));
      if (row.size() > 2)
        row.push_back(change(value, quantity.values.front()));
    }
  }
  return aligned(rows);
}

// What judges how well a run went and not what it found.
bool is_about_the_run(const ComparedQuantity &quantity)
{
  static const char *const words[] = {"steps",
                                      "cut_",
                                      "cell_",
                                      "different_",
                                      "worst_",
                                      "energy_residual",
                                      "doubtful",
                                      "force_evaluations",
                                      "mean_cell_bias",
                                      "idle_",
                                      "cells_moved",
                                      "seconds_"};
  return std::ranges::any_of(
      words, [&](const char *word) { return quantity.name.starts_with(word); });
}

std::string key_section(const Comparison &comparison)
{
  std::vector<ComparedQuantity> found, effort;
  for (const ComparedQuantity &quantity : key_results(comparison.runs))
    (is_about_the_run(quantity) ? effort : found).push_back(quantity);
  std::vector<ComparedQuantity> cost = costs(comparison.runs);
  for (const ComparedQuantity &quantity : effort)
    if (quantity.name.starts_with("steps[") ||
        quantity.name.starts_with("force_evaluations") ||
        quantity.name.starts_with("doubtful"))
      cost.push_back(quantity);
  return "\nKey results\n" + quantities(comparison, found) +
         "\nCost (more in compare.csv; times depend on the machine and on what "
         "else it did)\n" +
         quantities(comparison, cost);
}

std::string curve_section(const Comparison &comparison)
{
  if (comparison.curves.empty())
    return {};
  std::vector<Row> rows(1, Row{"curve", "range"});
  const bool several = comparison.runs.size() > 2;
  if (several)
    rows.front().insert(rows.front().begin() + 1, "run");
  rows.front().insert(rows.front().end(), {"mean", "largest", "at"});
  for (const StageDifference &curve : comparison.curves)
    for (std::size_t run = 1; run < comparison.runs.size(); ++run) {
      const auto &found = curve.of_run[run];
      if (!found)
        continue;
      const std::string &x = curve.pair.abscissa;
      Row &row = rows.emplace_back(
          Row{fmt::format("stage {}{}: {} over {}",
                          curve.stage,
                          curve.kind.empty() ? "" : ", " + curve.kind,
                          words_of(curve.pair.ordinate),
                          words_of(x))});
      if (several)
        row.push_back(comparison.runs[run].name);
      row.insert(row.end(),
                 {with_unit(x, found->from) + " to " + with_unit(x, found->to),
                  per_cent(found->relative_L2),
                  per_cent(found->relative_largest),
                  with_unit(x, found->at)});
    }
  return fmt::format(
             "\nCurves, difference from {}\n"
             "  Over the range that both curves of a stage have, between "
             "straight lines from point to point.\n"
             "  mean: root of the mean squared difference over that of the "
             "reference's values;\n"
             "  largest: largest difference over the reference's largest "
             "value, and where it is.\n\n",
             comparison.runs.front().name) +
         aligned(rows);
}

std::string place_words(const FieldGrid &grid, const Place &at)
{
  return grid.dimension == 2
             ? fmt::format("r {:.3g} mm, z {:.3g} mm", at[0] * 1e3, at[1] * 1e3)
             : fmt::format("x {:.3g}, y {:.3g}, z {:.3g} mm",
                           at[0] * 1e3,
                           at[1] * 1e3,
                           at[2] * 1e3);
}

std::string field_table(const ComparedState &state,
                        const FieldDifference &other)
{
  std::vector<Row> rows{
      {"field", "mean", "root mean square", "of reference", "largest", "at"}};
  for (const auto &[field, norm] : other.norms) {
    const std::string name =
        field + (field == "relative_density" ? "[-]" : "[Pa]");
    rows.push_back(
        {words_of(name),
         with_unit(name, norm.mean),
         with_unit(name, norm.root_mean_square),
         norm.reference_root_mean_square > 0
             ? per_cent(norm.root_mean_square / norm.reference_root_mean_square)
             : "-",
         with_unit(name, norm.largest),
         place_words(state.reference, norm.at)});
  }
  return aligned(rows);
}

std::string state_section(const Comparison &comparison,
                          const ComparedState &state)
{
  const char *const last =
      state.state.name == "end" ? ", the last common state" : "";
  std::string text = fmt::format("\nFields: {}{}\n", state.state.words, last);
  for (std::size_t run = 0; run < comparison.runs.size(); ++run) {
    const ResultCurve &curve = comparison.runs[run].curve;
    const std::size_t line = state.state.lines[run];
    text += fmt::format("  {}: step {}, mean relative density {:.4f}\n",
                        comparison.runs[run].name,
                        state.state.of_run[run].step,
                        curve.column("mean_relative_density[-]")[line]);
  }
  for (std::size_t run = 0; run < state.others.size(); ++run) {
    const FieldDifference &other = state.others[run];
    text += fmt::format("\n  {} less {}, {}\n",
                        comparison.runs[run + 1].name,
                        comparison.runs.front().name,
                        other.matching);
    if (other.outside > 0)
      text += fmt::format("  {} of the reference's points are outside\n",
                          per_cent(other.outside));
    text.append("\n").append(field_table(state, other));
    text += fmt::format("\n  solid volume {:.4f} mm3, of the reference {:.4f} "
                        "mm3 ({:+.4f} %);\n  difference of "
                        "density times volume, summed up on the reference's "
                        "mesh: {:+.4g} mm3\n",
                        other.mass * 1e9,
                        state.reference_mass * 1e9,
                        100 * (other.mass / state.reference_mass - 1),
                        other.mass_difference * 1e9 + 0.);
  }
  return text;
}
} // namespace

std::string comparison_summary(const Comparison &comparison)
{
  std::string text = fmt::format("tamp compare: {} runs of tamp {}\n\n",
                                 comparison.runs.size(),
                                 comparison.runs.front().command);
  std::vector<Row> rows;
  for (const ResultFolder &run : comparison.runs)
    rows.push_back({run.name + (rows.empty() ? " (the reference)" : ""),
                    run.status,
                    run.path.string()});
  text += aligned(rows);
  for (const std::string &warning : comparison.warnings)
    text += fmt::format("\n  warning: {}\n", warning);
  text += key_section(comparison) + curve_section(comparison);
  if (!comparison.states.empty())
    text += "\nDifferences of fields are weighted with the volumes of the "
            "reference's parts; compression is positive.\n";
  for (const ComparedState &state : comparison.states)
    text += state_section(comparison, state);
  return text;
}
} // namespace tamp::apps
