// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_equation_report_h
#define apps_fit_equation_report_h

#include <apps/output/plots.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// What is said of equations of compaction: key results, "EQUATION_NAME[unit]",
/// warnings, the table equations.csv, and plots of it.
struct EquationReport {
  std::vector<std::pair<std::string, double>> results;
  std::vector<std::string> warnings;
  /// Pressure, density and what each equation says in the range that was
  /// fitted.
  std::vector<std::string> header, remarks;
  std::vector<std::vector<double>> lines;
  std::vector<Plot> plots; ///< of ../equations.csv
};

/// The names of the equations, and "all-equations".
std::vector<std::string> compaction_equations();

/// Fits an equation, or all, to the curve.csv of a folder of `tamp die` (the
/// mean pressure of the punches, the mean density) or of `tamp probe` (the
/// axial stress), see fit_compaction_equations(). Of the curve it takes what
/// leads to the largest pressure: lines with a pressure above zero and above
/// that of all lines before; D_0 is the density of the first line, and it
/// is said if that is under pressure already. Throws InputError.
EquationReport report_equations(const std::filesystem::path &result,
                                const std::string &equation);
} // namespace tamp::apps

#endif
