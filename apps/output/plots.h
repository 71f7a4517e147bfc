// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_output_plots_h
#define apps_output_plots_h

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace tamp::apps
{
/// A gnuplot script without terminal and output: those are added.
struct Plot {
  std::string name; ///< of the files, without ending
  std::string script;
};

/// Writes `folder`/NAME.gp for each plot, which a user may edit and run again,
/// and runs gnuplot in `folder` for each format (svg, png, pdf). Never throws
/// because of gnuplot: returns a sentence that says what went wrong, empty if
/// nothing did.
std::string draw_plots(const std::filesystem::path &folder,
                       const std::vector<Plot> &plots,
                       const std::vector<std::string> &formats);

/// A part of the compact with one value: four corners (r, z), around [m].
struct ValueQuadrilateral {
  std::array<std::array<double, 2>, 4> corners;
  double value = 0;
};

/// Writes the quadrilaterals so that gnuplot's pm3d draws them, mirrored at
/// the axis, in mm. Throws OutputError.
void write_map(const std::filesystem::path &file,
               const std::vector<ValueQuadrilateral> &map);

/// How a map is coloured: an order of values, or values to both sides of zero,
/// which is white, red below it.
enum class Colours { sequential, about_zero };

/// The plot `name` of what write_map() wrote into `table`.
Plot map_plot(const std::string &name,
              const std::string &table,
              const std::string &title,
              const std::string &unit_of_values,
              Colours colours = Colours::sequential);

/// Plots of ../curve.csv of a pair of grains.
std::vector<Plot> contact_plots(bool impact);

/// Plots of ../curve.csv of packings.
std::vector<Plot> pack_plots();

/// Plots of ../curve.csv of a probe.
std::vector<Plot> probe_plots(bool unit_cell);

/// Plots of ../curve.csv and ../replicas.csv of several probes.
std::vector<Plot> replica_plots();

/// Plots of ../yield.csv and ../moduli.csv.
std::vector<Plot> scan_plots();
} // namespace tamp::apps

#endif
