// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_die_plots_h
#define apps_die_die_plots_h

#include <apps/output/plots.h>
#include <fem/die_model.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// What the plots of a die need to know of its run. Stages count from 1.
struct DiePlotFacts {
  std::vector<unsigned> press_stages, unload_stages, eject_stages;
  /// Stages after the peak.
  std::vector<unsigned> later_stages;
  double peak_height = 0, peak_radius = 0; ///< of the compact [m]
  /// Of the lower punch in the die, upwards, at the peak [m].
  double peak_lift = 0;
  /// "after ejection": what the state at the end is. Empty if the run ended
  /// with pressing.
  std::string end;
  bool maps = true; ///< the tables of DieMaps are there
};

/// The facts of a run of which these are the peak and the last step.
DiePlotFacts plot_facts(const fem::DieSettings &settings,
                        const fem::StepRecord &peak,
                        const fem::StepRecord &last);

/// Plots of ../curve.csv of a die and of its maps, those that have something to
/// show.
std::vector<Plot> die_plots(const DiePlotFacts &facts);
} // namespace tamp::apps

#endif
