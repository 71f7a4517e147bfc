// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_surface_plots_h
#define apps_fit_surface_plots_h

#include <apps/fit/cap_geometry.h>
#include <apps/output/plots.h>
#include <apps/run/run_folder.h>

#include <vector>

namespace tamp::apps
{
/// A yield surface in the p-q plane and what probes have found of it.
struct SurfacePicture {
  double density = 0;        ///< relative [-]
  double yield_pressure = 0; ///< where it ends on the axis of p [Pa]
  std::vector<StressPoint> line;
  /// Around the surfaces of fits to single replicas; empty without.
  std::vector<StressPoint> band;
  std::vector<StressPoint> yields;   ///< of branches
  std::vector<StressPoint> uniaxial; ///< states on uniaxial paths
};

/// Writes what surface_plots() draws: plots/surfaces.csv, plots/points.csv and,
/// if there are bands, plots/bands.csv. Throws OutputError.
void write_surfaces(const RunFolder &folder,
                    const std::vector<SurfacePicture> &surfaces);

/// Six of the surfaces at most, absolute and over their yield pressures, with
/// their bands.
std::vector<Plot> surface_plots(const std::vector<SurfacePicture> &surfaces);
} // namespace tamp::apps

#endif
