// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/cap_fit_files.h>
#include <fem/laws/cap_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string>

namespace tamp::apps
{
namespace
{
struct TableColumn {
  const char *name, *unit;
  double CapValues::*field;
};

constexpr std::array<TableColumn, 6> columns{
    TableColumn{"cohesion", "Pa", &CapValues::cohesion},
    TableColumn{"friction_angle", "rad", &CapValues::friction_angle},
    TableColumn{"cap_eccentricity", "-", &CapValues::eccentricity},
    TableColumn{"yield_pressure", "Pa", &CapValues::yield_pressure},
    TableColumn{"Young_modulus", "Pa", &CapValues::youngs_modulus},
    TableColumn{"Poisson_ratio", "-", &CapValues::poissons_ratio}};

std::vector<std::string> table_header()
{
  std::vector<std::string> names{
      "relative_density[-]", "relative_density_under_load[-]", "replicas[-]"};
  for (const TableColumn &column : columns)
    for (const char *suffix : {"", "_unsmoothed", "_deviation"})
      names.push_back(
          fmt::format("{}{}[{}]", column.name, suffix, column.unit));
  for (const char *name : {"cohesion_error[Pa]",
                           "cohesion_extrapolated[-]",
                           "shear_points[-]",
                           "shear_residual[-]",
                           "plastic_strain_ratio[-]",
                           "rigid_cap_eccentricity[-]",
                           "uniaxial_yield_pressure[Pa]",
                           "friction_angle_by_strain[rad]",
                           "friction_angle_by_work[rad]",
                           "friction_angle_by_peak[rad]"})
    names.emplace_back(name);
  return names;
}

std::vector<double> table_line(const CapLevel &level)
{
  std::vector<double> values{
      level.density, level.loaded_density, double(level.replicas)};
  for (const TableColumn &column : columns)
    for (const CapValues *kind : {&level.value, &level.mean, &level.deviation})
      values.push_back(kind->*column.field);
  values.insert(values.end(),
                {level.cohesion_error,
                 double(level.cohesion_extrapolated),
                 double(level.shear_points.size()),
                 level.shear_residual,
                 level.plastic_ratio,
                 level.rigid_eccentricity,
                 level.uniaxial_yield_pressure});
  values.insert(values.end(),
                level.angle_by_criterion.begin(),
                level.angle_by_criterion.end());
  return values;
}

SurfacePicture picture(const CapLevel &level)
{
  const fem::CapSurface<double> surface(
      fem::CapConstants<double>{level.value.cohesion,
                                level.value.friction_angle,
                                level.value.eccentricity,
                                level.value.yield_pressure});
  SurfacePicture result{
      level.density, level.value.yield_pressure, {}, {}, {}, {level.uniaxial}};
  result.line.push_back({0, surface.shear_limit(0.)});
  for (unsigned k = 0; k <= 60; ++k) {
    const double angle = k / 60. * std::acos(0.);
    result.line.push_back({surface.centre + surface.radius() * std::sin(angle),
                           surface.top() * std::cos(angle)});
  }
  for (const auto *points : {&level.shear_points, &level.cap_points})
    result.yields.insert(result.yields.end(), points->begin(), points->end());
  return result;
}

std::string panel(const char *title,
                  const char *name,
                  const std::string &unit,
                  const std::string &factor,
                  const std::string &more = "")
{
  return fmt::format(
      R"(set title "{0}"
plot "../fit.csv" using (column(density)):(column("{1}_unsmoothed[{2}]") * {3}):(column("{1}_deviation[{2}]") * {3}) with yerrorbars linecolor 2 linewidth 2 pointsize 0.8, "" using (column(density)):(column("{1}[{2}]") * {3}) with lines linecolor 1{4}
)",
      title,
      name,
      unit,
      factor,
      more);
}
} // namespace

void write_cap_table(const RunFolder &folder,
                     const CapFit &fit,
                     const std::vector<std::string> &remarks)
{
  std::vector<std::string> lines = remarks;
  lines.emplace_back("relative_density: of the unloaded powder; deviation: of "
                     "one replica, 0 if there is one only");
  lines.emplace_back("cohesion_error: standard error of d from the scatter of "
                     "the shear points, 0 if they are too few; "
                     "cohesion_extrapolated: 1 if they begin so far from the "
                     "axis that d is a guess");
  lines.emplace_back(
      "rigid_cap_eccentricity: R if lateral plastic strain were zero "
      "(plastic_strain_ratio 1.5); friction_angle_by_*: 0 without points");
  CurveWriter writer(folder.path() / "fit.csv", table_header(), lines);
  for (const CapLevel &level : fit.levels)
    writer.write(table_line(level));
}

std::vector<SurfacePicture> cap_surfaces(const CapFit &fit)
{
  std::vector<SurfacePicture> result;
  for (const CapLevel &level : fit.levels)
    result.push_back(picture(level));
  return result;
}

Plot cap_tables_plot()
{
  using namespace std::string_literals;
  const std::string degrees = "57.29577951308232";
  return {"tables",
          "set multiplot layout 2,3\nunset key\nset format y \"%g\"\n"
          "density = \"relative_density[-]\"\nset xlabel \"relative density\""
          "\nset xtics 0.1\nset tics font \",14\"\n" +
              "guess(name) = column(\"cohesion_extrapolated[-]\") == 1 ? "
              "column(name) * 1e-6 : NaN\n"s +
              panel("d [MPa] (open: a guess)",
                    "cohesion",
                    "Pa",
                    "1e-6",
                    ", \"\" using (column(density)):"
                    "(guess(\"cohesion_unsmoothed[Pa]\")) with points "
                    "linecolor 2 pointtype 6 pointsize 2 linewidth 2") +
              panel("friction angle {/Symbol b} [deg]",
                    "friction_angle",
                    "rad",
                    degrees) +
              panel("cap eccentricity R [-]", "cap_eccentricity", "-", "1") +
              panel("p_b [MPa]", "yield_pressure", "Pa", "1e-6") +
              panel("E [GPa]", "Young_modulus", "Pa", "1e-9") +
              panel("{/Symbol n} [-]", "Poisson_ratio", "-", "1") +
              "unset multiplot\n"};
}
} // namespace tamp::apps
