// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/equation_report.h>
#include <apps/fit/fit.h>
#include <apps/input/units.h>
#include <apps/output/curve_writer.h>

#include <cmath>
#include <fmt/format.h>

namespace tamp::apps
{
int run_equations(const FitRequest &request, const RunOptions &options)
{
  if (request.folders.size() != 1)
    throw InputError(fmt::format("--law {} is fitted to the curve of one "
                                 "folder, not of {}",
                                 request.law,
                                 request.folders.size()));
  const std::filesystem::path &result = request.folders.front();
  const EquationReport report = report_equations(result, request.law);
  RunOptions chosen = options;
  if (chosen.output.empty())
    chosen.output = result / "fit" / request.law;
  RunSession session(
      "fit", chosen, result.filename().string(), {result / "curve.csv"});
  return session.run([&]() -> RunEnd {
    CurveWriter table(session.folder().path() / "equations.csv",
                      report.header,
                      report.remarks);
    for (const std::vector<double> &line : report.lines)
      table.write(line);
    for (const auto &[name, value] : report.results)
      if (std::isfinite(value)) // an equation may have no solution
        session.result(name, value);
    for (const std::string &warning : report.warnings)
      session.warn(warning);
    session.draw(report.plots);
    return {};
  });
}
} // namespace tamp::apps
