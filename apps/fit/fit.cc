// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/cap_fit_files.h>
#include <apps/fit/constants_fit.h>
#include <apps/fit/fit.h>
#include <apps/fit/law_check.h>
#include <apps/fit/law_text.h>
#include <apps/input/units.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <set>
#include <utility>

namespace tamp::apps
{
namespace
{
/// Differences above which the user is told.
constexpr double wide_loading = 0.05, wide_slope = 0.10;

/// The laws: as --law names them, as Material/Type does, their subsection.
struct LawNames {
  const char *law, *type, *subsection;
  coupling::MaterialKind kind;
};
constexpr std::array<LawNames, 3> laws{
    LawNames{"drucker-prager-cap",
             "drucker-prager cap",
             "Drucker-Prager cap",
             coupling::MaterialKind::drucker_prager_cap},
    LawNames{"modified-cam-clay",
             "modified cam-clay",
             "Modified Cam-Clay",
             coupling::MaterialKind::modified_cam_clay},
    LawNames{"fkm-gurson",
             "fkm-gurson",
             "FKM-Gurson",
             coupling::MaterialKind::fkm_gurson}};

const LawNames &names_of(coupling::MaterialKind kind)
{
  return *std::ranges::find(laws, kind, &LawNames::kind);
}

std::string name_of(const std::filesystem::path &folder)
{
  const auto path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

std::string names_of(const FitRequest &request)
{
  std::vector<std::string> names;
  for (const auto &folder : request.folders)
    names.push_back(name_of(folder));
  return fmt::format("{}", fmt::join(names, " "));
}

std::vector<ProbeData> read_probes(const FitRequest &request)
{
  std::set<std::filesystem::path> different;
  std::vector<ProbeData> probes;
  for (const auto &folder : request.folders) {
    probes.push_back(read_probe(folder));
    if (!different.insert(std::filesystem::canonical(folder)).second)
      throw InputError(
          fmt::format("the folder '{}' is named twice", folder.string()));
  }
  return probes;
}

std::vector<std::filesystem::path> files_of(const FitRequest &request)
{
  std::vector<std::filesystem::path> files;
  for (const auto &folder : request.folders)
    std::ranges::copy(probe_files(folder), std::back_inserter(files));
  return files;
}

/// A fit of one law, from the tables of probes to the files.
class FitRun
{
public:
  FitRun(const FitRequest &request,
         const std::vector<ProbeData> &probes,
         RunSession &session)
      : request_(request), probes_(probes), session_(session)
  {
  }

  RunEnd give_cap(const CapFit &fit)
  {
    const auto remarks = cap_remarks(fit);
    const RunFolder &folder = session_.folder();
    folder.write("law.prm", cap_text(fit.law, remarks));
    folder.write("law_abaqus.inp", abaqus_text(fit.law, remarks));
    write_cap_table(folder, fit, remarks);
    const auto surfaces = cap_surfaces(fit);
    write_surfaces(folder, surfaces);
    for (const std::string &remark : fit.remarks)
      session_.warn(remark);
    session_.result("densities[-]", static_cast<double>(fit.levels.size()));
    session_.result("lowest_relative_density[-]", fit.levels.front().density);
    session_.result("highest_relative_density[-]", fit.levels.back().density);
    give_residuals(fit);
    coupling::MaterialChoice material;
    material.kind = coupling::MaterialKind::drucker_prager_cap;
    material.cap = fit.law;
    check(material,
          fit.levels.front().loaded_density,
          fit.levels.back().loaded_density);
    auto plots = surface_plots(surfaces);
    plots.push_back(cap_tables_plot());
    draw(plots);
    return {};
  }

  RunEnd give_constants(const ConstantsFit &fit)
  {
    const std::vector<std::string> remarks{
        fmt::format("{} fitted by tamp fit to {}.",
                    names_of(fit.law.kind).subsection,
                    names_of(request_)),
        fmt::format("Relative densities from {:.4g} to {:.4g}, under load; "
                    "outside is a guess. Root mean squares of the differences: "
                    "{:.2g} % on the paths, {:.2g} % at yield, "
                    "{:.2g} % of the moduli.",
                    fit.first_density,
                    fit.last_density,
                    100 * fit.path_residual,
                    100 * fit.yield_residual,
                    100 * fit.modulus_residual)};
    const RunFolder &folder = session_.folder();
    folder.write("law.prm",
                 constants_text(names_of(fit.law.kind).type,
                                names_of(fit.law.kind).subsection,
                                entries_of(fit),
                                remarks));
    write_constants_table(fit, remarks);
    write_surfaces(folder, fit.surfaces);
    for (const FittedConstant &constant : fit.constants)
      session_.result(column_of(constant), constant.value);
    session_.result("replicas[-]", fit.replicas);
    session_.result("residual_of_paths[-]", fit.path_residual);
    session_.result("residual_of_yield[-]", fit.yield_residual);
    session_.result("residual_of_moduli[-]", fit.modulus_residual);
    check(fit.law, fit.first_density, fit.last_density);
    draw(surface_plots(fit.surfaces));
    return {};
  }

private:
  static std::string column_of(const FittedConstant &constant,
                               const std::string &suffix = "")
  {
    std::string name = constant.name;
    std::erase(name, '\'');
    std::ranges::replace(name, ' ', '_');
    return fmt::format("{}{}[{}]", name, suffix, constant.unit);
  }

  static std::vector<std::pair<std::string, std::string>>
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

  void write_constants_table(const ConstantsFit &fit,
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
    values.insert(
        values.end(),
        {fit.path_residual, fit.yield_residual, fit.modulus_residual});
    CurveWriter(session_.folder().path() / "fit.csv", names, remarks)
        .write(values);
  }

  std::vector<std::string> cap_remarks(const CapFit &fit) const
  {
    double residual = 0;
    for (const CapLevel &level : fit.levels)
      residual = std::max(residual, level.shear_residual);
    return {
        fmt::format("Drucker-Prager cap fitted by tamp fit to {}.",
                    names_of(request_)),
        fmt::format("Relative densities are those of the unloaded powder. "
                    "Shape and elasticity were found from {:.4g} to {:.4g}, "
                    "p_b from {:.4g} to {:.4g}, on {} paths; outside is a "
                    "guess, also the first rows, with which tables begin "
                    "where the paths do.",
                    fit.levels.front().density,
                    fit.levels.back().density,
                    fit.hardening.front().density,
                    fit.hardening.back().density,
                    fit.hardening_from == Loading::isotropic ? "isotropic"
                                                             : "uniaxial"),
        fmt::format("Shear points are off their lines by {:.2g} % at most (rms "
                    "at a density); fit.csv has the scatter of replicas.",
                    100 * residual)};
  }

  void give_residuals(const CapFit &fit)
  {
    double residual = 0, ratio = 0, spread = 0;
    for (const CapLevel &level : fit.levels) {
      residual = std::max(residual, level.shear_residual);
      ratio += level.plastic_ratio / static_cast<double>(fit.levels.size());
      for (const double angle : level.angle_by_criterion)
        if (angle > 0)
          spread =
              std::max(spread, std::abs(angle - level.mean.friction_angle));
    }
    session_.result("replicas[-]", fit.levels.front().replicas);
    session_.result("largest_shear_residual[-]", residual);
    session_.result("mean_plastic_strain_ratio[-]", ratio);
    session_.result("largest_change_of_angle_with_criterion[deg]",
                    spread * 180 / std::acos(-1.));
  }

  void check(const coupling::MaterialChoice &law, double lowest, double highest)
  {
    const LawCheck found = check_law(law, probes_, lowest, highest);
    if (found.rows.empty())
      return;
    CurveWriter writer(
        session_.folder().path() / "curve.csv",
        {"relative_density[-]", "stress_zz[Pa]", "law_stress_zz[Pa]"},
        {"uniaxial strain: mean of the probes, and a point of the law"});
    for (const CheckRow &row : found.rows)
      writer.write(std::array{row.relative_density, row.data, row.law});
    session_.heading("A point of the law under uniaxial strain");
    session_.result("mean_difference_of_loading[-]", found.mean_difference);
    session_.result("largest_difference_of_loading[-]", found.worst_difference);
    session_.result("at_relative_density[-]", found.worst_density);
    session_.result("unloading_slope_of_probes[Pa]", found.data_slope);
    session_.result("unloading_slope_of_law[Pa]", found.law_slope);
    session_.result("difference_of_unloading_slope[-]",
                    found.slope_difference());
    judge(found);
  }

  void judge(const LawCheck &found)
  {
    if (!found.complete)
      session_.warn("the point of the law did not get to the end of its path");
    if (found.worst_difference > wide_loading)
      session_.warn(fmt::format(
          "under uniaxial strain the axial stress of the law is up to {:.1f} % "
          "(at a relative density of {:.3g}) off that of the probes, more than "
          "{:.0f} %; see plots/compaction",
          100 * found.worst_difference,
          found.worst_density,
          100 * wide_loading));
    if (!(found.data_slope > 0))
      session_.warn("the uniaxial probes are not unloaded: the unloading slope "
                    "of the law was not checked");
    else if (std::abs(found.slope_difference()) > wide_slope)
      session_.warn(fmt::format(
          "the unloading slope of the law, from the peak to its half, is "
          "{:+.1f} % off that of the probes, more than {:.0f} %",
          100 * found.slope_difference(),
          100 * wide_slope));
  }

  void draw(std::vector<Plot> plots)
  {
    plots.push_back({"compaction",
                     R"(set title "Uniaxial compaction"
set xlabel "relative density [-]"
set ylabel "axial stress [MPa]"
density = "relative_density[-]"
plot "../curve.csv" using (column(density)):(column("stress_zz[Pa]") / 1e6) with points pointsize 0.8 title "probes", \
     "" using (column(density)):(column("law_stress_zz[Pa]") / 1e6) with lines linecolor 2 title "law"
)"});
    session_.draw(plots);
  }

  const FitRequest &request_;
  const std::vector<ProbeData> &probes_;
  RunSession &session_;
};
// Grains slide long before their packing fails: an irreversible strain may be
// reached below the state on the uniaxial path, and then no cap is possible.
CapFit fit_some_cap(const std::vector<ProbeData> &probes,
                    const std::optional<YieldCriterion> &criterion)
{
  if (criterion)
    return fit_cap(probes, *criterion);
  try {
    return fit_cap(probes, YieldCriterion::strain);
  } catch (const InputError &problem) {
    try {
      CapFit fit = fit_cap(probes, YieldCriterion::peak);
      fit.remarks.emplace_back(
          "yield by irreversible strain is below the states on the uniaxial "
          "path: shear lines were drawn through peaks (--criterion peak)");
      return fit;
    } catch (const InputError &) {
      throw problem;
    }
  }
}
} // namespace

std::vector<std::string> fitted_laws()
{
  std::vector<std::string> names;
  for (const LawNames &known : laws)
    names.emplace_back(known.law);
  return names;
}

int run_fit(const FitRequest &request, const RunOptions &options)
{
  const auto law = std::ranges::find(laws, request.law, &LawNames::law);
  if (law == laws.end())
    throw InputError(fmt::format("there is no law '{}' to fit", request.law));
  const std::vector<ProbeData> probes = read_probes(request);
  RunOptions chosen = options;
  if (chosen.output.empty())
    chosen.output = request.folders.front() / "fit" / request.law;
  const auto run = [&](const auto &fit, auto give) {
    RunSession session("fit", chosen, names_of(request), files_of(request));
    return session.run([&] {
      FitRun work(request, probes, session);
      return (work.*give)(fit);
    });
  };
  if (law->kind == coupling::MaterialKind::drucker_prager_cap)
    return run(fit_some_cap(probes, request.criterion), &FitRun::give_cap);
  return run(fit_constants(law->kind,
                           probes,
                           request.criterion.value_or(YieldCriterion::strain)),
             &FitRun::give_constants);
}
} // namespace tamp::apps
