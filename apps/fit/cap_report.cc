// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/cap_fit_files.h>
#include <apps/fit/cap_report.h>
#include <apps/fit/law_text.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numbers>

namespace tamp::apps
{
namespace
{
double largest_residual(const CapFit &fit)
{
  return std::ranges::max(fit.levels, {}, &CapLevel::shear_residual)
      .shear_residual;
}

std::vector<std::string> remarks_on(const CapFit &fit, const FitReport &report)
{
  std::vector<std::string> remarks = report.data;
  remarks.push_back(fmt::format(
      "Relative densities are those of the unloaded powder. Shape "
      "and elasticity were found from {:.4g} to {:.4g}, p_b from "
      "{:.4g} to {:.4g}, on {} paths; outside is a guess, also "
      "where tables begin before the scans. The powder starts "
      "where the paths do; rows below are there because it dilates "
      "a little when it is first loaded.",
      fit.levels.front().density,
      fit.levels.back().density,
      fit.hardening.front().density,
      fit.hardening.back().density,
      fit.hardening_from == Loading::isotropic ? "isotropic" : "uniaxial"));
  remarks.push_back(
      fmt::format("Shear points are off their lines by {:.2g} % at most (rms "
                  "at a density); fit.csv has the scatter of replicas.",
                  100 * largest_residual(fit)));
  return remarks;
}

void give_results(const CapFit &fit, RunSession &session)
{
  const auto count = static_cast<double>(fit.levels.size());
  double ratio = 0, spread = 0;
  for (const CapLevel &level : fit.levels) {
    ratio += level.plastic_ratio / count;
    for (const double angle : level.angle_by_criterion)
      if (angle > 0)
        spread = std::max(spread, std::abs(angle - level.mean.friction_angle));
  }
  session.result("densities[-]", count);
  session.result("lowest_relative_density[-]", fit.levels.front().density);
  session.result("highest_relative_density[-]", fit.levels.back().density);
  session.result(
      "replicas[-]",
      std::ranges::max(fit.levels, {}, &CapLevel::replicas).replicas);
  session.result("largest_shear_residual[-]", largest_residual(fit));
  session.result("mean_plastic_strain_ratio[-]", ratio);
  session.result("largest_change_of_angle_with_criterion[deg]",
                 spread * 180 / std::numbers::pi);
  session.result("densities_of_extrapolated_cohesion[-]",
                 static_cast<double>(std::ranges::count(
                     fit.levels, true, &CapLevel::cohesion_extrapolated)));
}
} // namespace

void report_cap(const CapFit &fit, const FitReport &report)
{
  RunSession &session = report.session;
  const RunFolder &folder = session.folder();
  const auto remarks = remarks_on(fit, report);
  folder.write("law.prm", cap_text(fit.law, remarks));
  folder.write("law_abaqus.inp", abaqus_text(fit.law, remarks));
  write_cap_table(folder, fit, remarks);
  const auto surfaces = cap_surfaces(fit);
  write_surfaces(folder, surfaces);
  for (const std::string &remark : fit.remarks)
    session.warn(remark);
  give_results(fit, session);
  coupling::MaterialChoice material;
  material.kind = coupling::MaterialKind::drucker_prager_cap;
  material.cap = fit.law;
  auto plots = surface_plots(surfaces);
  plots.push_back(cap_tables_plot());
  std::ranges::move(report_law(report,
                               material,
                               fit.levels.front().loaded_density,
                               fit.levels.back().loaded_density),
                    std::back_inserter(plots));
  session.draw(plots);
}
} // namespace tamp::apps
