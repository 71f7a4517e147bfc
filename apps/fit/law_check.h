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
  double relative_density = 0;    ///< under load [-]
  double data = 0;                ///< mean of the probes [Pa]
  double deviation = 0;           ///< of one probe, with N - 1 [Pa]
  double law = 0;                 ///< [Pa]
  double lowest = 0, highest = 0; ///< of the fits to single replicas [Pa]
};

/// A state while the axial stress falls and the lateral strain rests,
/// compression positive.
struct UnloadingState {
  double recovered = 0; ///< axial strain since the peak, expansion positive [-]
  double lateral = 0;   ///< stress [Pa]
};

/// States of the probes, their mean, and of the law.
struct UnloadingRow {
  double share = 1; ///< axial stress over that at the peak [-]
  UnloadingState data, law;
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
  /// Axial stresses at the peak, of the probes their mean [Pa].
  double data_peak = 0, law_peak = 0;
  /// From the peak to where the probes end; none if they are not unloaded.
  std::vector<UnloadingRow> unloading;
  bool complete = true; ///< the law went all the way

  double slope_difference() const; ///< law over data, less 1; 0 without data
};

/// Drives the law along uniaxial strain, from its initial density to the
/// largest one that the uniaxial probes have, and back as far as they are
/// unloaded, half way at least, and compares with their mean, while it is
/// loaded between two densities under load.
/// @param replicas  laws fitted to single replicas; only loaded
LawCheck check_law(const coupling::MaterialChoice &law,
                   const std::vector<ProbeData> &probes,
                   double first_density,
                   double last_density,
                   const std::vector<coupling::MaterialChoice> &replicas = {});
} // namespace tamp::apps

#endif
