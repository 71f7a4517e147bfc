// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/law_check.h>
#include <apps/fit/law_report.h>
#include <apps/output/curve_writer.h>

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
/// Differences above which the user is told.
constexpr double wide_loading = 0.05, wide_unloading = 0.10;

constexpr const char *compaction_plot = R"(set title "Uniaxial compaction"
set xlabel "relative density [-]"
set ylabel "axial stress [MPa]"
density = "relative_density[-]"
mega(name) = column(name) / 1e6
plot "../curve.csv" using (column(density)):(mega("law_lowest_stress_zz[Pa]")):(mega("law_highest_stress_zz[Pa]")) with filledcurves linecolor 2 fillstyle transparent solid 0.25 noborder title "fits to single replicas", \
     "" using (column(density)):(mega("stress_zz[Pa]")):(mega("stress_zz_deviation[Pa]")) with yerrorbars linecolor 1 linewidth 1 pointsize 0.8 title "probes, deviation of one", \
     "" using (column(density)):(mega("law_stress_zz[Pa]")) with lines linecolor 2 linewidth 3 title "law"
)";

constexpr const char *unloading_plot =
    R"(set multiplot layout 1,2 title "Unloading without lateral strain"
set yrange [0:*]
mega(name) = column(name) / 1e6
set xlabel "axial stress [MPa]"
set ylabel "lateral stress [MPa]"
set xrange [0:*]
plot "../unloading.csv" using (mega("stress_zz[Pa]")):(mega("lateral_stress[Pa]")) with points linecolor 1 pointsize 0.8 title "probes", \
     "" using (mega("law_stress_zz[Pa]")):(mega("law_lateral_stress[Pa]")) with lines linecolor 2 linewidth 3 title "law"
set xlabel "recovered axial strain [%]"
set ylabel "axial stress [MPa]"
plot "../unloading.csv" using (100 * column("recovered_strain[-]")):(mega("stress_zz[Pa]")) with points linecolor 1 pointsize 0.8 title "probes", \
     "" using (100 * column("law_recovered_strain[-]")):(mega("law_stress_zz[Pa]")) with lines linecolor 2 linewidth 3 title "law"
unset multiplot
)";

void write_loading(const LawCheck &found, const RunFolder &folder)
{
  CurveWriter writer(
      folder.path() / "curve.csv",
      {"relative_density[-]",
       "stress_zz[Pa]",
       "stress_zz_deviation[Pa]",
       "law_stress_zz[Pa]",
       "law_lowest_stress_zz[Pa]",
       "law_highest_stress_zz[Pa]"},
      {"uniaxial strain: mean of the probes, deviation of one of them (0 if "
       "there is one only), and a point of the law",
       "law_lowest, law_highest: of the fits to single replicas; those of the "
       "law if there are none"});
  for (const CheckRow &row : found.rows)
    writer.write(std::array{row.relative_density,
                            row.data,
                            row.deviation,
                            row.law,
                            row.lowest,
                            row.highest});
}

void write_unloading(const LawCheck &found, const RunFolder &folder)
{
  CurveWriter writer(
      folder.path() / "unloading.csv",
      {"share_of_peak[-]",
       "stress_zz[Pa]",
       "lateral_stress[Pa]",
       "recovered_strain[-]",
       "law_stress_zz[Pa]",
       "law_lateral_stress[Pa]",
       "law_recovered_strain[-]"},
      {"from the peak on, without lateral strain: mean of the probes and a "
       "point of the law, where axial stresses are the same share of theirs"});
  for (const UnloadingRow &row : found.unloading)
    writer.write(std::array{row.share,
                            row.share * found.data_peak,
                            row.data.lateral,
                            row.data.recovered,
                            row.share * found.law_peak,
                            row.law.lateral,
                            row.law.recovered});
}

void give_results(const LawCheck &found, RunSession &session)
{
  session.heading("A point of the law under uniaxial strain");
  session.result("mean_difference_of_loading[-]", found.mean_difference);
  session.result("largest_difference_of_loading[-]", found.worst_difference);
  session.result("at_relative_density[-]", found.worst_density);
  session.result("unloading_slope_of_probes[Pa]", found.data_slope);
  session.result("unloading_slope_of_law[Pa]", found.law_slope);
  session.result("difference_of_unloading_slope[-]", found.slope_difference());
  if (found.unloading.empty())
    return;
  const UnloadingRow &end = found.unloading.back();
  session.heading(
      fmt::format("Unloaded to {:.3g} % of the peak", 100 * end.share));
  session.result("lateral_stress_of_probes[Pa]", end.data.lateral);
  session.result("lateral_stress_of_law[Pa]", end.law.lateral);
  session.result("recovered_strain_of_probes[-]", end.data.recovered);
  session.result("recovered_strain_of_law[-]", end.law.recovered);
}

void judge_unloading(const LawCheck &found, RunSession &session)
{
  if (!(found.data_slope > 0)) {
    session.warn("the uniaxial probes are not unloaded: the unloading of the "
                 "law was not checked");
    return;
  }
  if (std::abs(found.slope_difference()) > wide_unloading)
    session.warn(fmt::format(
        "the unloading slope of the law, from the peak to its half, is "
        "{:+.1f} % off that of the probes, more than {:.0f} %",
        100 * found.slope_difference(),
        100 * wide_unloading));
  const UnloadingRow &end = found.unloading.back();
  if (std::abs(end.law.lateral / end.data.lateral - 1) > wide_unloading)
    session.warn(fmt::format(
        "unloaded to {:.3g} % of the peak the law keeps a lateral stress of "
        "{:.3g} MPa, the probes {:.3g} MPa, and recovers an axial strain of "
        "{:.3g} %, the probes {:.3g} %: so will wall pressure, ejection force "
        "and spring-back of dies differ; see plots/unloading and --moduli",
        100 * end.share,
        end.law.lateral / 1e6,
        end.data.lateral / 1e6,
        100 * end.law.recovered,
        100 * end.data.recovered));
}

void judge(const LawCheck &found, RunSession &session)
{
  if (!found.complete)
    session.warn("the point of the law did not get to the end of its path");
  if (found.worst_difference > wide_loading)
    session.warn(fmt::format(
        "under uniaxial strain the axial stress of the law is up to {:.1f} % "
        "(at a relative density of {:.3g}) off that of the probes, more than "
        "{:.0f} %; see plots/compaction",
        100 * found.worst_difference,
        found.worst_density,
        100 * wide_loading));
  judge_unloading(found, session);
}
} // namespace

std::vector<Plot>
report_law(const FitReport &report,
           const coupling::MaterialChoice &law,
           double lowest_density,
           double highest_density,
           const std::vector<coupling::MaterialChoice> &replicas)
{
  const LawCheck found =
      check_law(law, report.probes, lowest_density, highest_density, replicas);
  if (found.rows.empty())
    return {};
  RunSession &session = report.session;
  write_loading(found, session.folder());
  give_results(found, session);
  judge(found, session);
  std::vector<Plot> plots{{"compaction", compaction_plot}};
  if (!found.unloading.empty()) {
    write_unloading(found, session.folder());
    plots.push_back({"unloading", unloading_plot});
  }
  return plots;
}
} // namespace tamp::apps
