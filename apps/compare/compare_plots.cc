// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/compare_plots.h>
#include <apps/compare/compared_curves.h>
#include <apps/output/curve_writer.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace tamp::apps
{
namespace
{
struct Axis {
  std::string column, label;
  double factor = 1; ///< from SI to what the label says
  bool logarithmic = false;
};

// A column drawn over that of the drawing.
struct Line {
  std::string column, words; ///< words: what it is, if there are several
};

struct Drawing {
  std::string name, title;
  Axis x, y; ///< column of y is not used
  std::vector<Line> lines;
  std::vector<std::string> kinds = {}; ///< of stages; none: all
  std::string more = {};               ///< lines of gnuplot
};

std::vector<Drawing> die_drawings()
{
  const std::vector<std::string> pressing{"press", "unload"};
  const Axis density{"mean_relative_density[-]", "mean relative density [-]"};
  const Axis approach{"approach[m]", "approach of the punches [mm]", 1e3};
  const Axis pressure{"", "pressure [MPa]", 1e-6};
  const Axis travel{"travel[m]", "travel of the compact in the die [mm]", 1e3};
  const Axis force{"", "force [kN]", 1e-3};
  return {{"compaction",
           "Compaction curves",
           density,
           {"", "punch pressure [MPa]", 1e-6, true},
           {{"upper_pressure[Pa]", "upper punch"},
            {"lower_pressure[Pa]", "lower punch"}},
           pressing},
          {"pressure_displacement",
           "Pressures over the approach of the punches",
           approach,
           pressure,
           {{"upper_pressure[Pa]", "upper punch"},
            {"lower_pressure[Pa]", "lower punch"}},
           pressing},
          {"wall_pressure",
           "Pressure on the die wall",
           density,
           pressure,
           {{"wall_pressure[Pa]", ""}},
           pressing},
          {"wall_friction",
           "Friction force of the die wall",
           approach,
           force,
           {{"wall_friction_force[N]", ""}},
           pressing},
          {"density_range",
           "Largest less smallest relative density",
           density,
           {"", "density range [-]"},
           {{"density_range[-]", ""}},
           pressing,
           "set yrange [0:*]\n"},
          {"ejection",
           "Ejection force",
           travel,
           force,
           {{"lower_force[N]", ""}},
           {"eject"},
           "set yrange [0:*]\n"}};
}

std::vector<Drawing> probe_drawings()
{
  const Axis strain{"strain_zz[-]", "axial strain {/Symbol e}_{zz} [-]"};
  const Axis stress{"", "stress [MPa]", 1e-6};
  return {{"stress_strain",
           "Stress over strain",
           strain,
           stress,
           {{"stress_zz[Pa]", "axial"}, {"lateral_stress[Pa]", "lateral"}}},
          {"lateral_stress",
           "Lateral over axial stress",
           {"stress_zz[Pa]", "axial stress [MPa]", 1e-6},
           {"", "lateral stress [MPa]", 1e-6},
           {{"lateral_stress[Pa]", ""}}},
          {"density_pressure",
           "Relative density over pressure",
           {"pressure[Pa]", "mean pressure [MPa]", 1e-6, true},
           {"", "relative density [-]"},
           {{"relative_density[-]", ""}}},
          {"stress_path",
           "Stress paths",
           {"pressure[Pa]", "mean pressure [MPa]", 1e-6},
           {"", "deviatoric stress [MPa]", 1e-6},
           {{"deviatoric_stress[Pa]", ""}}},
          {"coordination",
           "Coordination of the grains",
           {"relative_density[-]", "relative density [-]"},
           {"", "contacts per grain [-]"},
           {{"coordination_number[-]", ""}}}};
}

std::vector<Drawing> other_drawings(const std::string &command)
{
  const Axis density{"relative_density[-]", "relative density [-]"};
  if (command == "pack")
    return {
        {"pressure_density",
         "Compression of the packings",
         density,
         {"", "stress [MPa]", 1e-6, true},
         {{"axial_stress[Pa]", "axial"}, {"lateral_stress[Pa]", "lateral"}}},
        {"coordination",
         "Coordination of grains that carry load",
         density,
         {"", "contacts per grain [-]"},
         {{"mechanical_coordination_number[-]", ""}}}};
  const Axis normal{"", "normal force [mN]", 1e3};
  const Axis time{"time[s]", "time [{/Symbol m}s]", 1e6};
  return {{"force_overlap",
           "Normal force over overlap",
           {"overlap[m]", "overlap [{/Symbol m}m]", 1e6},
           normal,
           {{"normal_force[N]", ""}}},
          {"force_slip",
           "Tangential force over slip",
           {"slip_x[m]", "slip [{/Symbol m}m]", 1e6},
           {"", "tangential force on the first grain [mN]", 1e3},
           {{"tangential_force_x[N]", ""}}},
          {"force_time",
           "Normal force of an impact",
           time,
           normal,
           {{"normal_force[N]", ""}}}};
}

std::vector<Drawing> drawings(const std::string &command)
{
  if (command == "die")
    return die_drawings();
  return command == "probe" ? probe_drawings() : other_drawings(command);
}

// gnuplot's condition for a line of a run to belong to a drawing.
std::string wanted(const ResultFolder &run, const Drawing &drawing)
{
  if (drawing.kinds.empty())
    return "1";
  std::string condition = "0";
  for (const StageLines &lines : run.curve.stages())
    if (std::ranges::count(drawing.kinds, run.curve.kind(lines.stage)))
      condition += fmt::format(" || column(\"stage\") == {}", lines.stage);
  return condition;
}

std::string value(const Axis &axis, const std::string &column)
{
  const std::string scaled =
      fmt::format("column(\"{}\") * {}", column, axis.factor);
  return axis.logarithmic ? fmt::format("({0} > 0 ? {0} : NaN)", scaled)
                          : scaled;
}

// Does a run have the column, with more than one value?
bool has_range(const ResultFolder &run, const std::string &column)
{
  if (!run.curve.has(column))
    return false;
  const auto [least, most] = std::ranges::minmax(run.curve.column(column));
  return least < most;
}

// All lines of all runs; empty if there are none.
std::string curves(std::span<const ResultFolder> runs, const Drawing &drawing)
{
  std::string text;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const std::string condition = wanted(runs[run], drawing);
    if (condition == "0" || !has_range(runs[run], drawing.x.column))
      continue;
    for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
      const Line &line = drawing.lines[i];
      if (!runs[run].curve.has(line.column))
        continue;
      text += fmt::format(
          R"({}"curve_{}.csv" using (({}) ? {} : NaN):({}) with lines linetype {}{} linewidth {} {})",
          text.empty() ? "plot " : ", \\\n     ",
          run + 1,
          condition,
          value(drawing.x, drawing.x.column),
          value(drawing.y, line.column),
          run + 1,
          i > 0 ? " dashtype 2" : "",
          i > 0
              ? 3
              : 3 + 2 * (runs.size() - 1 - run), // what is below stays in sight
          i > 0 ? "notitle" : "title \"" + runs[run].name + "\"");
    }
  }
  if (!text.empty() && drawing.lines.size() > 1)
    for (std::size_t i = 0; i < drawing.lines.size(); ++i)
      text += fmt::format(
          ", \\\n     keyentry with lines linewidth 3 linecolor rgb "
          "\"#666666\"{} title \"{}\"",
          i > 0 ? " dashtype 2" : "",
          drawing.lines[i].words);
  return text;
}

// The largest value of a column of all runs.
double largest(std::span<const ResultFolder> runs, const std::string &column)
{
  double most = 0;
  for (const ResultFolder &run : runs)
    if (run.curve.has(column))
      most = std::max(most, std::ranges::max(run.curve.column(column)));
  return most;
}

std::string script(std::span<const ResultFolder> runs, const Drawing &drawing)
{
  const std::string lines = curves(runs, drawing);
  if (lines.empty())
    return {};
  const std::size_t entries =
      runs.size() + (drawing.lines.size() > 1 ? drawing.lines.size() : 0);
  const auto rows = static_cast<double>((entries + 2) / 3); // of the key
  std::string text = fmt::format(R"(set title "{}"
set xlabel "{}"
set ylabel "{}"
set key at screen 0.53, screen 0.015 center bottom horizontal width 2
set bmargin at screen {:.3f}
set linetype 5 linecolor rgb "#7b4b94" linewidth 3.5 pointtype 7
set linetype 6 linecolor rgb "#5c5c5c" linewidth 3.5 pointtype 7
)",
                                 drawing.title,
                                 drawing.x.label,
                                 drawing.y.label,
                                 0.165 + 0.047 * rows);
  if (drawing.x.logarithmic)
    text += "set logscale x\nset format x \"%g\"\n";
  if (drawing.y.logarithmic) {
    const double most =
        largest(runs, drawing.lines.front().column) * drawing.y.factor;
    text += "set logscale y\nset format y \"%g\"\n";
    if (most > 0)
      text += fmt::format("set yrange [{:.3g}:*]\n", most / 1000);
  }
  return text + drawing.more + lines + "\n";
}
} // namespace

std::vector<Plot> compared_curve_plots(std::span<const ResultFolder> runs)
{
  std::vector<Plot> plots;
  for (const Drawing &drawing : drawings(runs.front().command))
    if (std::string text = script(runs, drawing); !text.empty())
      plots.push_back({drawing.name, std::move(text)});
  return plots;
}

void write_curves(const std::filesystem::path &folder,
                  std::span<const ResultFolder> runs)
{
  std::set<std::string> wanted{"stage", "step"};
  for (const Drawing &drawing : drawings(runs.front().command)) {
    wanted.insert(drawing.x.column);
    for (const Line &line : drawing.lines)
      wanted.insert(line.column);
  }
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const ResultCurve &curve = runs[run].curve;
    std::vector<std::string> names;
    for (const std::string &name : wanted)
      if (curve.has(name))
        names.push_back(name);
    CurveWriter writer(
        folder / fmt::format("curve_{}.csv", run + 1), names, {runs[run].name});
    for (std::size_t i = 0; i < curve.size(); ++i) {
      std::vector<double> values;
      for (const std::string &name : names)
        values.push_back(curve.column(name)[i]);
      writer.write(values);
    }
  }
}
} // namespace tamp::apps
