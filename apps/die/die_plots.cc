// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/die_plots.h>

#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
// gnuplot's condition for a line of the curve to be of one of the stages.
std::string of(const std::vector<unsigned> &stages)
{
  std::string condition = "0";
  for (const unsigned stage : stages)
    condition += fmt::format(" || column(\"stage\") == {}", stage);
  return condition;
}

std::vector<unsigned> both(std::vector<unsigned> first,
                           const std::vector<unsigned> &second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Plot compaction(const DiePlotFacts &facts)
{
  return {"compaction",
          fmt::format(R"(set title "Compaction curve"
set xlabel "mean relative density [-]"
set ylabel "punch pressure [MPa]"
set logscale y
set format y "%g"
density = "mean_relative_density[-]"
stats "../curve.csv" using (column("upper_pressure[Pa]") > column("lower_pressure[Pa]") ? column("upper_pressure[Pa]") : column("lower_pressure[Pa]")) nooutput
most = STATS_max / 1e6
if (most > 0) set yrange [most / 1000 < *:*]
mega(name) = ({}) && column(name) > 0 ? column(name) / 1e6 : NaN
plot "../curve.csv" using (column(density)):(mega("upper_pressure[Pa]")) with lines title "upper punch", \
     "" using (column(density)):(mega("lower_pressure[Pa]")) with lines dashtype 2 title "lower punch"
)",
                      of(both(facts.press_stages, facts.unload_stages)))};
}

Plot pressures()
{
  return {"pressures",
          R"(set title "Pressures on the tools"
set xlabel "step"
set ylabel "pressure [MPa]"
plot "../curve.csv" using (column("step")):(column("upper_pressure[Pa]") / 1e6) with lines title "upper punch", \
     "" using (column("step")):(column("lower_pressure[Pa]") / 1e6) with lines title "lower punch", \
     "" using (column("step")):(column("wall_pressure[Pa]") / 1e6) with lines title "die wall"
)"};
}

Plot forces(const DiePlotFacts &facts)
{
  return {"forces",
          fmt::format(R"(set title "Forces while pressing and unloading"
set xlabel "approach of the punches [mm]"
set ylabel "force [kN]"
approach(x) = ({}) ? (column("upper_displacement[m]") + column("lower_displacement[m]")) * 1e3 : NaN
plot "../curve.csv" using (approach(0)):(column("upper_force[N]") / 1e3) with lines title "upper punch", \
     "" using (approach(0)):(column("lower_force[N]") / 1e3) with lines title "lower punch", \
     "" using (approach(0)):(column("wall_normal_force[N]") / 1e3) with lines title "die wall, normal", \
     "" using (approach(0)):(column("wall_friction_force[N]") / 1e3) with lines title "die wall, friction"
)",
                      of(both(facts.press_stages, facts.unload_stages)))};
}

Plot stress_path(const DiePlotFacts &facts)
{
  return {"radial_stress",
          fmt::format(R"(set title "Radial against axial pressure"
set xlabel "mean pressure of the punches [MPa]"
set ylabel "pressure on the die wall [MPa]"
axial(use) = use ? (column("upper_pressure[Pa]") + column("lower_pressure[Pa]")) / 2e6 : NaN
wall(name) = column(name) / 1e6
plot "../curve.csv" using (axial({})):(wall("wall_pressure[Pa]")) with lines title "pressing"{}
)",
                      of(facts.press_stages),
                      facts.unload_stages.empty()
                          ? ""
                          : fmt::format(R"(, \
     "" using (axial({})):(wall("wall_pressure[Pa]")) with lines title "unloading")",
                                        of(facts.unload_stages)))};
}

Plot transmission(const DiePlotFacts &facts)
{
  return {
      "transmission",
      fmt::format(R"(set title "Transmission of the punch force while pressing"
set xlabel "mean relative density [-]"
set ylabel "ratio [-]"
set yrange [0:1.05]
larger(a, b) = a > b ? a : b
press(part, whole) = ({}) && whole > 0 ? part / whole : NaN
plot "../curve.csv" using (column("mean_relative_density[-]")):(press(column("upper_force[N]") + column("lower_force[N]") - larger(column("upper_force[N]"), column("lower_force[N]")), larger(column("upper_force[N]"), column("lower_force[N]")))) with lines title "smaller / larger punch force", \
     "" using (column("mean_relative_density[-]")):(press(column("wall_pressure[Pa]"), larger(column("upper_pressure[Pa]"), column("lower_pressure[Pa]")))) with lines title "wall / larger punch pressure"
)",
                  of(facts.press_stages))};
}

Plot ejection(const DiePlotFacts &facts)
{
  return {"ejection",
          fmt::format(R"(set title "Ejection"
set xlabel "travel of the compact in the die [mm]"
set ylabel "force [N]"
set yrange [0:*]
travel(x) = ({}) && x > 0 ? x * 1e3 : NaN
lift(x) = column("lower_displacement[m]") - column("die_displacement[m]") - {}
plot "../curve.csv" using (travel(lift(0))):(column("lower_force[N]")) with lines title "lower punch", \
     "" using (travel(lift(0))):(column("upper_force[N]")) with lines title "upper punch"
)",
                      of(facts.eject_stages),
                      facts.peak_lift)};
}

Plot spring_back(const DiePlotFacts &facts)
{
  return {"spring_back",
          fmt::format(R"(set title "Spring-back since the peak"
set xlabel "travel of the compact in the die [mm]"
set ylabel "change of length [%]"
lift(x) = ({}) ? (column("lower_displacement[m]") - column("die_displacement[m]") - {}) * 1e3 : NaN
change(name, peak) = 100 * (column(name) / peak - 1)
plot "../curve.csv" using (lift(0)):(change("compact_height[m]", {})) with lines title "height", \
     "" using (lift(0)):(change("compact_radius[m]", {})) with lines title "radius"
)",
                      of(facts.later_stages),
                      facts.peak_lift,
                      facts.peak_height,
                      facts.peak_radius)};
}

Plot effort()
{
  return {"effort",
          R"(set title "Iterations and evaluations of all points"
set xlabel "step"
set ylabel "number per step [-]"
set yrange [0:*]
plot "../curve.csv" using (column("step")):(column("cell_updates[-]")) with steps title "cell updates", \
     "" using (column("step")):(column("iterations[-]")) with steps title "iterations of the accepted step"
)"};
}
} // namespace

DiePlotFacts plot_facts(const fem::DieSettings &settings,
                        const fem::StepRecord &peak,
                        const fem::StepRecord &last)
{
  using fem::StageKind;
  DiePlotFacts facts;
  for (unsigned i = 0; i < settings.stages.size() && i <= last.stage; ++i) {
    const StageKind kind = settings.stages[i].kind;
    if (kind == StageKind::press)
      facts.press_stages.push_back(i + 1);
    if (kind == StageKind::unload)
      facts.unload_stages.push_back(i + 1);
    if (kind == StageKind::eject)
      facts.eject_stages.push_back(i + 1);
    if (i > peak.stage)
      facts.later_stages.push_back(i + 1);
  }
  facts.peak_height = peak.compact_height;
  facts.peak_radius = peak.compact_radius;
  facts.peak_lift = peak.lower_displacement - peak.die_displacement;
  if (last.stage >= settings.stages.size())
    return facts;
  const std::string when = last.stage_progress < 1 ? "during" : "after";
  const StageKind kind = settings.stages[last.stage].kind;
  if (kind == StageKind::unload)
    facts.end = when + " unloading";
  if (kind == StageKind::eject)
    facts.end = when + " ejection";
  return facts;
}

std::vector<Plot> die_plots(const DiePlotFacts &facts)
{
  std::vector<Plot> plots{compaction(facts), pressures(), forces(facts)};
  if (!facts.press_stages.empty()) {
    plots.push_back(stress_path(facts));
    plots.push_back(transmission(facts));
  }
  if (!facts.eject_stages.empty())
    plots.push_back(ejection(facts));
  if (!facts.later_stages.empty())
    plots.push_back(spring_back(facts));
  const std::string density = "relative density [-]";
  if (facts.maps && !facts.press_stages.empty())
    plots.push_back(map_plot("density_map",
                             "density_map.dat",
                             "Relative density at the peak of the force",
                             density));
  if (facts.maps && !facts.end.empty()) {
    plots.push_back(map_plot("density_map_final",
                             "final_density_map.dat",
                             "Relative density " + facts.end,
                             density));
    plots.push_back(map_plot("axial_stress_final",
                             "final_axial_stress.dat",
                             "Axial stress " + facts.end,
                             "stress [MPa], tension negative",
                             Colours::about_zero));
    plots.push_back(map_plot("hoop_stress_final",
                             "final_hoop_stress.dat",
                             "Hoop stress " + facts.end,
                             "stress [MPa], tension negative",
                             Colours::about_zero));
  }
  plots.push_back(effort());
  return plots;
}
} // namespace tamp::apps
