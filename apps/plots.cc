// SPDX-License-Identifier: BSD-3-Clause
#include <apps/curve_writer.h>
#include <apps/plots.h>

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tamp::apps
{
namespace
{
constexpr const char *head = R"(# Run again with: gnuplot {0}.gp
if (!exists("format")) format = "png"
if (format eq "svg") set terminal svg size 1200,900 dynamic enhanced font "Sans,22" background "white"; else if (format eq "pdf") set terminal pdfcairo size 20cm,15cm enhanced font "Sans,16"; else set terminal pngcairo size 1200,900 enhanced font "Sans,22"
set output "{0}.".format
set encoding utf8
set datafile separator comma
set datafile columnheaders
set border 3 linewidth 1.5 linecolor rgb "#444444"
set tics nomirror out scale 0.6 textcolor rgb "#222222"
set grid linecolor rgb "#dddddd" linetype 1 linewidth 1
set key noenhanced Left reverse spacing 1.2
set linetype 1 linecolor rgb "#0b6e99" linewidth 3.5 pointtype 7
set linetype 2 linecolor rgb "#d1495b" linewidth 3.5 pointtype 7
set linetype 3 linecolor rgb "#edae49" linewidth 3.5 pointtype 7
set linetype 4 linecolor rgb "#3b8132" linewidth 3.5 pointtype 7
)";

// Runs gnuplot in a folder; true if all went well.
bool run_gnuplot(const std::filesystem::path &folder,
                 const std::string &script,
                 const std::string &format)
{
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(
        &actions, stream, "gnuplot.log", O_WRONLY | O_CREAT | O_APPEND, 0644);
  std::array<std::string, 4> words{
      "gnuplot", "-e", fmt::format("format='{}'", format), script};
  std::array<char *, 5> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i)
    arguments[i] = words[i].data();
  pid_t process = 0;
  const int error = posix_spawnp(
      &process, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    return false;
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR)
      return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}
} // namespace

std::string draw_plots(const std::filesystem::path &folder,
                       const std::vector<Plot> &plots,
                       const std::vector<std::string> &formats)
{
  std::string failed;
  for (const Plot &plot : plots) {
    const std::string script = plot.name + ".gp";
    std::ofstream out(folder / script);
    out << fmt::format(fmt::runtime(head), plot.name) << plot.script;
    out.close();
    for (const std::string &format : formats)
      if (const std::string picture = plot.name + "." + format;
          !out || !run_gnuplot(folder, script, format)) {
        failed += (failed.empty() ? "" : ", ") + picture;
        std::error_code ignored;
        std::filesystem::remove(folder / picture, ignored);
      }
  }
  std::error_code error;
  const auto log = folder / "gnuplot.log";
  if (std::filesystem::file_size(log, error) == 0 && !error)
    std::filesystem::remove(log, error);
  if (failed.empty())
    return {};
  const bool ran = std::filesystem::exists(log, error);
  return fmt::format("gnuplot did not draw {}; the scripts are in {}{}",
                     failed,
                     folder.string(),
                     ran ? ", the reason is in gnuplot.log there"
                         : " (is gnuplot installed?)");
}

void write_map(const std::filesystem::path &file,
               const std::vector<ValueQuadrilateral> &map)
{
  std::ofstream out(file);
  out << "# r[mm] z[mm] value; each block of two lines by two is a part\n";
  for (const double side : {1e3, -1e3})
    for (const ValueQuadrilateral &part : map) {
      const auto corner = [&](std::size_t i) {
        out << fmt::format("{} {} {}\n",
                           side * part.corners[i][0],
                           1e3 * part.corners[i][1],
                           part.value);
      };
      corner(0);
      corner(1);
      out << '\n';
      corner(3);
      corner(2);
      out << "\n\n";
    }
  if (!out.flush())
    throw OutputError(fmt::format("'{}' cannot be written", file.string()));
}

std::vector<Plot> die_plots(const std::vector<unsigned> &press_stages)
{
  std::string pressing = "0";
  for (const unsigned stage : press_stages)
    pressing += fmt::format(" || column(\"stage\") == {}", stage);
  return {
      {"compaction",
       R"(set title "Compaction curve"
set xlabel "mean relative density [-]"
set ylabel "punch pressure [MPa]"
set logscale y
set format y "%g"
set key left top
density = "mean_relative_density[-]"
mega(name) = column(name) > 0 ? column(name) / 1e6 : NaN
plot "../curve.csv" using (column(density)):(mega("upper_pressure[Pa]")) with lines title "upper punch", \
     "" using (column(density)):(mega("lower_pressure[Pa]")) with lines dashtype 2 title "lower punch"
)"},
      {"pressures",
       R"(set title "Pressures on the tools"
set xlabel "step"
set ylabel "pressure [MPa]"
set key left top
plot "../curve.csv" using (column("step")):(column("upper_pressure[Pa]") / 1e6) with lines title "upper punch", \
     "" using (column("step")):(column("lower_pressure[Pa]") / 1e6) with lines title "lower punch", \
     "" using (column("step")):(column("wall_pressure[Pa]") / 1e6) with lines title "die wall"
)"},
      {"forces",
       R"(set title "Forces on the powder"
set xlabel "upper punch displacement [mm]"
set ylabel "force [kN]"
set key left top
travel = "upper_displacement[m]"
plot "../curve.csv" using (column(travel) * 1e3):(column("upper_force[N]") / 1e3) with lines title "upper punch", \
     "" using (column(travel) * 1e3):(column("lower_force[N]") / 1e3) with lines title "lower punch", \
     "" using (column(travel) * 1e3):(column("wall_friction_force[N]") / 1e3) with lines title "wall friction"
)"},
      {"transmission",
       fmt::format(R"(set title "Transmission of the punch force while pressing"
set xlabel "mean relative density [-]"
set ylabel "force ratio [-]"
set key left bottom
set yrange [0:1.05]
press(name, by) = ({}) && column(by) > 0 ? column(name) / column(by) : NaN
plot "../curve.csv" using (column("mean_relative_density[-]")):(press("lower_force[N]", "upper_force[N]")) with lines title "lower / upper punch force", \
     "" using (column("mean_relative_density[-]")):(press("wall_pressure[Pa]", "upper_pressure[Pa]")) with lines title "wall / upper punch pressure"
)",
                   pressing)},
      {"density_map",
       R"(set title "Relative density at the end of pressing"
unset datafile
set datafile separator whitespace
set xlabel "r [mm]"
set ylabel "z [mm]"
set cblabel "relative density [-]"
set size ratio -1
set autoscale xfix
set autoscale yfix
set ytics 1
set border 0
unset grid
unset key
set pm3d map corners2color c1
set palette defined (0 "#440154", 1 "#3b528b", 2 "#21918c", 3 "#5ec962", 4 "#fde725")
set colorbox horizontal user origin screen 0.16, screen 0.16 size screen 0.68, screen 0.03
set bmargin at screen 0.30
splot "density_map.dat" using 1:2:3 with pm3d
)"},
      {"effort",
       R"(set title "Iterations and evaluations of all points"
set xlabel "step"
set ylabel "number per step [-]"
set key right top
set yrange [0:*]
plot "../curve.csv" using (column("step")):(column("cell_updates[-]")) with steps title "cell updates", \
     "" using (column("step")):(column("iterations[-]")) with steps title "iterations of the accepted step"
)"}};
}

std::vector<Plot> pack_plots()
{
  return {{"pressure_density",
           R"(set title "Compression of the packing"
set xlabel "relative density [-]"
set ylabel "stress [MPa]"
set logscale y
set format y "%g"
set key left top
density = "relative_density[-]"
mega(name) = column(name) > 0 ? column(name) / 1e6 : NaN
plot "../curve.csv" using (column(density)):(mega("axial_stress[Pa]")) with points pointsize 0.5 title "axial", \
     "" using (column(density)):(mega("lateral_stress[Pa]")) with points pointsize 0.5 title "lateral"
)"},
          {"coordination",
           R"(set title "Coordination of the grains"
set xlabel "relative density [-]"
set ylabel "contacts per grain [-]"
set key left top
density = "relative_density[-]"
plot "../curve.csv" using (column(density)):(column("coordination_number[-]")) with points pointsize 0.5 title "all grains", \
     "" using (column(density)):(column("mechanical_coordination_number[-]")) with points pointsize 0.5 title "grains that carry load"
)"}};
}

std::vector<Plot> probe_plots(bool unit_cell)
{
  std::vector<Plot> plots{{"stress_strain",
                           R"(set title "Stress against strain"
set xlabel "axial strain {/Symbol e}_{zz} [-]"
set ylabel "stress [MPa]"
set key left top
strain = "strain_zz[-]"
plot "../curve.csv" using (column(strain)):(column("stress_zz[Pa]") / 1e6) with lines title "axial", \
     "" using (column(strain)):((column("stress_xx[Pa]") + column("stress_yy[Pa]")) / 2e6) with lines title "lateral"
)"},
                          {"density_pressure",
                           R"(set title "Relative density against pressure"
set xlabel "mean pressure [MPa]"
set ylabel "relative density [-]"
set logscale x
set format x "%g"
unset key
pressure = "pressure[Pa]"
plot "../curve.csv" using (column(pressure) > 0 ? column(pressure) / 1e6 : NaN):(column("relative_density[-]")) with lines
)"},
                          {"stress_path",
                           R"(set title "Stress path"
set xlabel "mean pressure [MPa]"
set ylabel "deviatoric stress [MPa]"
unset key
plot "../curve.csv" using (column("pressure[Pa]") / 1e6):(column("deviatoric_stress[Pa]") / 1e6) with lines
)"}};
  if (!unit_cell)
    return plots;
  plots.push_back({"coordination",
                   R"(set title "Coordination of the grains"
set xlabel "axial strain {/Symbol e}_{zz} [-]"
set ylabel "contacts per grain [-]"
set key right bottom
strain = "strain_zz[-]"
plot "../curve.csv" using (column(strain)):(column("coordination_number[-]")) with lines title "all grains", \
     "" using (column(strain)):(column("mechanical_coordination_number[-]")) with lines title "grains that carry load"
)"});
  plots.push_back({"contacts",
                   R"(set title "Plastic and sliding contacts"
set xlabel "axial strain {/Symbol e}_{zz} [-]"
set ylabel "share of the contacts [-]"
set yrange [0:1.05]
set key right center
strain = "strain_zz[-]"
share(name) = column("contacts[-]") > 0 ? column(name) / column("contacts[-]") : NaN
plot "../curve.csv" using (column(strain)):(share("plastic_contacts[-]")) with lines title "plastic", \
     "" using (column(strain)):(share("sliding_contacts[-]")) with lines title "sliding"
)"});
  return plots;
}
} // namespace tamp::apps
