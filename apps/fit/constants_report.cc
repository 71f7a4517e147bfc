// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/constants_report.h>
#include <apps/fit/law_names.h>
#include <apps/fit/law_text.h>
#include <apps/output/curve_writer.h>

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace tamp::apps
{
namespace
{
std::string column_of(const FittedConstant &constant,
                      const std::string &suffix = "")
{
  std::string name = constant.name;
  std::erase(name, '\'');
  std::ranges::replace(name, ' ', '_');
  return fmt::format("{}{}[{}]", name, suffix, constant.unit);
}

std::vector<std::pair<std::string, std::string>>
entries_of(const ConstantsFit &fit)
{
  std::vector<std::pair<std::string, std::string>> entries;
  for (const FittedConstant &constant : fit.constants)
    entries.emplace_back(constant.name,
                         constant.unit == "Pa"
                             ? fmt::format("{:.7g} MPa", constant.value / 1e6)
                             : fmt::format("{:.7g}", constant.value));
  return entries;
}

void write_table(const ConstantsFit &fit,
                 const RunFolder &folder,
                 const std::vector<std::string> &remarks)
{
  std::vector<std::string> names{"lowest_relative_density[-]",
                                 "highest_relative_density[-]",
                                 "replicas[-]"};
  std::vector<double> values{
      fit.first_density, fit.last_density, double(fit.replicas)};
  for (const FittedConstant &constant : fit.constants) {
    names.push_back(column_of(constant));
    names.push_back(column_of(constant, "_deviation"));
    values.insert(values.end(), {constant.value, constant.deviation});
  }
  for (const char *name :
       {"path_residual[-]", "yield_residual[-]", "modulus_residual[-]"})
    names.emplace_back(name);
  values.insert(values.end(),
                {fit.path_residual, fit.yield_residual, fit.modulus_residual});
  CurveWriter(folder.path() / "fit.csv", names, remarks).write(values);
}

std::vector<std::string> remarks_on(const ConstantsFit &fit,
                                    const FitReport &report)
{
  std::vector<std::string> remarks = report.data;
  remarks.push_back(fmt::format(
      "Relative densities from {:.4g} to {:.4g}, under load; outside is a "
      "guess. Root mean squares of the differences: {:.2g} % on the paths, "
      "{:.2g} % at yield, {:.2g} % of the moduli.",
      fit.first_density,
      fit.last_density,
      100 * fit.path_residual,
      100 * fit.yield_residual,
      100 * fit.modulus_residual));
  return remarks;
}

void give_results(const ConstantsFit &fit, RunSession &session)
{
  for (const FittedConstant &constant : fit.constants)
    session.result(column_of(constant), constant.value);
  session.result("replicas[-]", fit.replicas);
  session.result("residual_of_paths[-]", fit.path_residual);
  session.result("residual_of_yield[-]", fit.yield_residual);
  session.result("residual_of_moduli[-]", fit.modulus_residual);
}
} // namespace

void report_constants(const ConstantsFit &fit, const FitReport &report)
{
  RunSession &session = report.session;
  const RunFolder &folder = session.folder();
  const LawNames &names = names_of(fit.law.kind);
  const auto remarks = remarks_on(fit, report);
  folder.write(
      "law.prm",
      constants_text(names.type, names.subsection, entries_of(fit), remarks));
  if (fit.law.kind == coupling::MaterialKind::modified_cam_clay)
    folder.write("law_abaqus.inp",
                 abaqus_text(fit.law.cam_clay, fit.last_density, remarks));
  else
    session.warn("there is no law_abaqus.inp: *POROUS METAL PLASTICITY of "
                 "Abaqus is the surface of Gurson alone, without that of "
                 "Fleck, Kuhn and McMeeking, which this law has below a "
                 "relative density of 0.90");
  write_table(fit, folder, remarks);
  write_surfaces(folder, fit.surfaces);
  give_results(fit, session);
  auto plots = surface_plots(fit.surfaces);
  std::ranges::move(report_law(report,
                               fit.law,
                               fit.first_density,
                               fit.last_density,
                               fit.replica_laws),
                    std::back_inserter(plots));
  session.draw(plots);
}
} // namespace tamp::apps
