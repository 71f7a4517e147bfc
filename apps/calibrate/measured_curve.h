// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_measured_curve_h
#define apps_calibrate_measured_curve_h

#include <apps/calibrate/compaction_curve.h>

#include <cstddef>
#include <filesystem>
#include <string>

namespace tamp::apps
{
/// What a measured curve may leave to be said beside it; 0: it is not said.
struct CurveReference {
  /// Relative density of the powder at the displacement zero, or at the first
  /// height [-].
  double density_at_start = 0;
  double height_at_start = 0; ///< at the displacement zero [m]
  double area = 0;            ///< of the punch [m2]
  double solid_density = 0;   ///< of the grains [kg/m3]
};

/// A measured curve and what was done to read it.
struct MeasuredCurve {
  CompactionCurve curve;
  std::string columns;  ///< that were read, in words
  std::size_t rows = 0; ///< of the file
};

/// Reads a measured compaction curve, see MeasuredTable, with a column each of
///   relative_density[-], density[g/cm3], height[mm] or displacement[mm]
///   pressure[MPa] (also axial_pressure, axial_stress, upper_pressure,
///     stress_zz) or force[kN] (also upper_force), compression positive
/// and perhaps lateral_pressure[MPa] (also wall_pressure, radial_pressure,
/// stress_xx); other columns do not matter. The powder is loaded once, and may
/// be unloaded once. Throws InputError naming file and line: that density turns
/// more than once, that pressure falls while it is loaded, what is missing.
MeasuredCurve read_measured_curve(const std::filesystem::path &file,
                                  const CurveReference &reference);

/// The same curve with at most `most` points in loading and in unloading: where
/// there are more, those in equal intervals of density are averaged. The peak
/// stays.
CompactionCurve thinned(const CompactionCurve &curve, std::size_t most);
} // namespace tamp::apps

#endif
