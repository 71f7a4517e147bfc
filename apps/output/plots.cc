// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/curve_writer.h>
#include <apps/output/plots.h>

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
set key noenhanced Left reverse spacing 1.2 tmargin center horizontal
set linetype 1 linecolor rgb "#0b6e99" linewidth 3.5 pointtype 7
set linetype 2 linecolor rgb "#d1495b" linewidth 3.5 pointtype 7
set linetype 3 linecolor rgb "#edae49" linewidth 3.5 pointtype 7
set linetype 4 linecolor rgb "#3b8132" linewidth 3.5 pointtype 7
set linetype 5 linecolor rgb "#6a4c93" linewidth 3.5 pointtype 7
set linetype 6 linecolor rgb "#1b9e9e" linewidth 3.5 pointtype 7
set linetype 7 linecolor rgb "#8d5524" linewidth 3.5 pointtype 7
set linetype 8 linecolor rgb "#666666" linewidth 3.5 pointtype 7
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

Plot map_plot(const std::string &name,
              const std::string &table,
              const std::string &title,
              const std::string &unit_of_values,
              Colours colours)
{
  const char *palette =
      colours == Colours::sequential
          ? R"(set palette defined (0 "#440154", 1 "#482878", 2 "#3e4989", 3 "#31688e", 4 "#26828e", 5 "#1f9e89", 6 "#35b779", 7 "#6ece58", 8 "#b5de2b", 9 "#fde725")
)"
          : R"(set palette defined (0 "#67001f", 1 "#b2182b", 2 "#d6604d", 3 "#f4a582", 4 "#fddbc7", 5 "#f7f7f7", 6 "#d1e5f0", 7 "#92c5de", 8 "#4393c3", 9 "#2166ac", 10 "#053061")
stats table using 3 name "value" nooutput
most = value_max > -value_min ? value_max : -value_min
if (most > 0) set cbrange [-most:most]
)";
  return {name,
          fmt::format(R"(table = "{}"
set title "{}"
unset datafile
set datafile separator whitespace
set xlabel "r [mm]"
set ylabel "z [mm]"
set cblabel "{}"
set size ratio -1
set autoscale xfix
set autoscale yfix
decade(length) = 10 ** floor(log10(length))
apart(length) = length <= 0 ? 1 : decade(length) * (length > 4.5 * decade(length) ? 2 : length > 2 * decade(length) ? 1 : 0.5)
stats table using 1 name "radius" nooutput
stats table using 2 name "height" nooutput
set xtics apart(radius_max)
set ytics apart(height_max - height_min)
set border 0
unset grid
unset key
set pm3d map corners2color c1
{}set cbtics font ",18"
set colorbox horizontal user origin screen 0.21, screen 0.16 size screen 0.68, screen 0.03
set lmargin at screen 0.17
set rmargin at screen 0.93
set tmargin at screen 0.90
set bmargin at screen 0.36
# Lines of the same colour close the seams between the parts.
splot table using 1:2:3 with pm3d, table using 1:2:3 with lines linewidth 1 linecolor palette
)",
                      table,
                      title,
                      unit_of_values,
                      palette)};
}

std::vector<Plot> pack_plots()
{
  return {{"pressure_density",
           R"(set title "Compression of the packing"
set xlabel "relative density [-]"
set ylabel "stress [MPa]"
set logscale y
set format y "%g"
density = "relative_density[-]"
mega(name) = column(name) > 0 ? column(name) / 1e6 : NaN
plot "../curve.csv" using (column(density)):(mega("axial_stress[Pa]")) with points pointsize 0.5 title "axial", \
     "" using (column(density)):(mega("lateral_stress[Pa]")) with points pointsize 0.5 title "lateral"
)"},
          {"coordination",
           R"(set title "Coordination of the grains"
set xlabel "relative density [-]"
set ylabel "contacts per grain [-]"
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
strain = "strain_zz[-]"
plot "../curve.csv" using (column(strain)):(column("coordination_number[-]")) with lines title "all grains", \
     "" using (column(strain)):(column("mechanical_coordination_number[-]")) with lines title "grains that carry load"
)"});
  plots.push_back({"contacts",
                   R"(set title "Plastic and sliding contacts"
set xlabel "axial strain {/Symbol e}_{zz} [-]"
set ylabel "share of the contacts [-]"
set yrange [0:1.05]
strain = "strain_zz[-]"
share(name) = column("contacts[-]") > 0 ? column(name) / column("contacts[-]") : NaN
plot "../curve.csv" using (column(strain)):(share("plastic_contacts[-]")) with lines title "plastic", \
     "" using (column(strain)):(share("sliding_contacts[-]")) with lines title "sliding"
)"});
  return plots;
}
} // namespace tamp::apps
