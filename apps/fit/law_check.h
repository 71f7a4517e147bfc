// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_law_check_h
#define apps_fit_law_check_h

#include <apps/fit/probe_data.h>
#include <coupling/material_factory.h>

#include <vector>

namespace tamp::apps
{
/// Axial stress under uniaxial strain at a relative density, compression
/// positive.
struct CheckRow {
  double relative_density = 0; ///< under load [-]
  double data = 0, law = 0;    ///< [Pa]
};

/// A single point of a law against the uniaxial probes that it was fitted to.
struct LawCheck {
  std::vector<CheckRow> rows;
  double mean_difference = 0;  ///< of the rows, relative, without sign [-]
  double worst_difference = 0; ///< the largest one [-]
  double worst_density = 0;    ///< where [-]
  /// Axial stress over strain from the peak to its half while the lateral
  /// strain rests [Pa]; that of the data is zero if they are not unloaded.
  double data_slope = 0, law_slope = 0;
  bool complete = true; ///< the law went all the way

  double slope_difference() const; ///< law over data, less 1; 0 without data
};

/// Drives the law along uniaxial strain, from its initial density to the
/// largest one that the uniaxial probes have, and half way back, and compares
/// with their mean between two densities under load.
LawCheck check_law(const coupling::MaterialChoice &law,
                   const std::vector<ProbeData> &probes,
                   double first_density,
                   double last_density);
} // namespace tamp::apps

#endif
