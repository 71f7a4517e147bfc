// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/compaction_equations.h>
#include <apps/fit/equation_report.h>
#include <apps/input/csv_reader.h>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
constexpr const char *all = "all-equations";
constexpr double no_pressure = 0.01; // share of the largest one
constexpr std::array names{
    "heckel", "kawakita", "walker", "panelli-ambrosio", "adams"};

struct LoadingCurve {
  std::vector<double> pressure, density;
  double initial_density = 0, initial_pressure = 0;
};

LoadingCurve read_loading(const std::filesystem::path &file)
{
  CsvReader table(file, "curve");
  const auto of_die = table.find("mean_relative_density", dimension::number);
  const auto density =
      of_die ? *of_die : table.column("relative_density", dimension::number);
  const auto upper = table.column(of_die ? "upper_pressure" : "stress_zz",
                                  dimension::pressure);
  const auto lower =
      of_die ? table.column("lower_pressure", dimension::pressure) : upper;
  LoadingCurve curve;
  double largest = 0;
  while (table.next()) {
    const double P = (table.number(upper) + table.number(lower)) / 2;
    const double D = table.number(density);
    if (curve.initial_density == 0) {
      curve.initial_density = D;
      curve.initial_pressure = P;
    }
    if (P > largest) {
      curve.pressure.push_back(P);
      curve.density.push_back(D);
      largest = P;
    }
  }
  return curve;
}

/// Does the equation count from the density before compaction?
bool begins_at_start(const CompactionFit &fit)
{
  return fit.name == "kawakita" || fit.name == "adams";
}

std::vector<std::string> remarks_of(const std::vector<CompactionFit> &fits)
{
  std::vector<std::string> remarks;
  for (const CompactionFit &fit : fits) {
    std::string remark = fit.name + ": " + fit.equation;
    for (const auto &[name, value] : fit.parameters)
      remark += fmt::format("; {} = {:.6g}", name, value);
    remarks.push_back(remark +
                      fmt::format("; r^2 = {:.6f}; {:.6g} Pa to {:.6g} Pa",
                                  fit.r_squared,
                                  fit.lowest_pressure,
                                  fit.highest_pressure));
  }
  return remarks;
}

std::vector<double> line_of(const LoadingCurve &curve,
                            const std::vector<CompactionFit> &fits,
                            std::size_t i)
{
  const double P = curve.pressure[i];
  std::vector<double> line{P, curve.density[i]};
  for (const CompactionFit &fit : fits)
    line.push_back(P >= fit.lowest_pressure && P <= fit.highest_pressure
                       ? fit.fitted_density[i]
                       : std::numeric_limits<double>::quiet_NaN());
  return line;
}

Plot plot_of(const std::vector<CompactionFit> &fits)
{
  std::string script = R"(set title "Equations of compaction"
set xlabel "pressure [MPa]"
set ylabel "relative density [-]"
set logscale x
set format x "%g"
pressure = "pressure[Pa]"
plot "../equations.csv" using (column(pressure) / 1e6):(column("relative_density[-]")) with points pointsize 0.8 linecolor rgb "#888888" title "curve")";
  constexpr std::array colours{
      "#0b6e99", "#d1495b", "#edae49", "#3b8132", "#6a4c93"};
  for (std::size_t i = 0; i < fits.size(); ++i)
    script += fmt::format(R"(, \
     "" using (column(pressure) / 1e6):(column("{0}[-]")) with lines linewidth 3.5 linecolor rgb "{1}" title "{0}, r^2 = {2:.4f}")",
                          fits[i].name,
                          colours.at(i),
                          fits[i].r_squared);
  return {"equations", script + "\n"};
}
} // namespace

std::vector<std::string> compaction_equations()
{
  std::vector<std::string> known(names.begin(), names.end());
  known.emplace_back(all);
  return known;
}

EquationReport report_equations(const std::filesystem::path &result,
                                const std::string &equation)
{
  const auto file = result / "curve.csv";
  const LoadingCurve curve = read_loading(file);
  std::vector<CompactionFit> fits;
  try {
    fits = fit_compaction_equations(
        curve.pressure, curve.density, curve.initial_density);
  } catch (const std::invalid_argument &error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
  if (equation != all)
    std::erase_if(fits, [&](const auto &fit) { return fit.name != equation; });
  EquationReport report;
  report.header = {"pressure[Pa]", "relative_density[-]"};
  report.remarks = remarks_of(fits);
  for (std::size_t i = 0; i < curve.pressure.size(); ++i)
    report.lines.push_back(line_of(curve, fits, i));
  for (const CompactionFit &fit : fits) {
    report.header.push_back(fit.name + "[-]");
    const auto add = [&](const std::string &name, double value) {
      report.results.emplace_back(fit.name + "_" + name, value);
    };
    for (const auto &[name, value] : fit.parameters)
      add(name, value);
    add("r_squared[-]", fit.r_squared);
    add("density_error[-]", fit.density_error);
    add("lowest_pressure[Pa]", fit.lowest_pressure);
    add("highest_pressure[Pa]", fit.highest_pressure);
    if (!fit.remark.empty())
      report.warnings.push_back(fit.name + ": " + fit.remark);
  }
  if (std::ranges::any_of(fits, begins_at_start) &&
      curve.initial_pressure > no_pressure * curve.pressure.back())
    report.warnings.push_back(
        fmt::format("kawakita and adams take the relative density {:.4f} for "
                    "that before compaction, but the curve begins at {:.3g} "
                    "MPa: their parameters depend on that",
                    curve.initial_density,
                    curve.initial_pressure / 1e6));
  report.plots = {plot_of(fits)};
  return report;
}
} // namespace tamp::apps
