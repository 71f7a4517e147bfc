// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_equation_report_h
#define apps_equation_report_h

#include <apps/plots.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// What is said of equations of compaction: key results, "EQUATION_NAME[unit]",
/// warnings, and plots of ../equations.csv.
struct EquationReport {
  std::vector<std::pair<std::string, double>> results;
  std::vector<std::string> warnings;
  std::vector<Plot> plots;
};

/// Is it the name of an equation, or "all-equations"?
bool is_compaction_equation(const std::string &name);

/// Fits an equation, or all, to the curve.csv of a folder of `tamp die` (the
/// mean pressure of the punches, the mean density) or of `tamp probe` (the
/// axial stress), see fit_compaction_equations(). Of the curve it takes what
/// leads to the largest pressure: lines with a pressure above zero and above
/// that of all lines before; D_0 is the density of the first line, and it
/// is said if that is under pressure already. Writes
/// equations.csv to `output`: pressure, density and what each equation says in
/// the range that was fitted. Throws InputError, OutputError.
EquationReport report_equations(const std::filesystem::path &result,
                                const std::string &equation,
                                const std::filesystem::path &output);
} // namespace tamp::apps

#endif
