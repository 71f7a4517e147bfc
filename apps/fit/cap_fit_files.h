// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_cap_fit_files_h
#define apps_fit_cap_fit_files_h

#include <apps/fit/cap_fit.h>
#include <apps/fit/surface_plots.h>

#include <vector>

namespace tamp::apps
{
/// Writes fit.csv, a line per density. Throws OutputError.
void write_cap_table(const RunFolder &folder,
                     const CapFit &fit,
                     const std::vector<std::string> &remarks);

/// The yield surfaces of all densities, with the points of the probes.
std::vector<SurfacePicture> cap_surfaces(const CapFit &fit);

/// The tables of fit.csv over density, with error bars.
Plot cap_tables_plot();
} // namespace tamp::apps

#endif
