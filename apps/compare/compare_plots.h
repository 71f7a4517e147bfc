// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_compare_compare_plots_h
#define apps_compare_compare_plots_h

#include <apps/compare/compared_fields.h>
#include <apps/compare/result_folder.h>
#include <apps/output/plots.h>

#include <filesystem>
#include <span>
#include <vector>

namespace tamp::apps
{
/// Curves of all runs over each other, those that have something to show; what
/// write_curves() writes is drawn.
std::vector<Plot> compared_curve_plots(std::span<const ResultFolder> runs);

/// Writes curve_1.csv, curve_2.csv ... of the runs, the columns that are drawn.
/// Throws OutputError.
void write_curves(const std::filesystem::path &folder,
                  std::span<const ResultFolder> runs);

/// Writes the section of the compact through the pressing axis, in the shape of
/// the reference, with the differences of density and axial stress of each run
/// in each state, and gives their plots; where nothing differs there is none.
/// In three dimensions the section is y = 0, x >= 0; no plots where no element
/// has a face there. Throws OutputError.
std::vector<Plot> write_maps(const std::filesystem::path &folder,
                             const std::vector<ComparedState> &states,
                             std::span<const ResultFolder> runs);

/// A name as gnuplot's enhanced text shows it.
std::string plot_text(const std::string &name);
} // namespace tamp::apps

#endif
