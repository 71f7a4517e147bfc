// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_check_material_trial_h
#define apps_check_material_trial_h

#include <coupling/material_factory.h>
#include <dem/dynamics.h>
#include <dem/remarks.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tamp::apps
{
/// A point of the material pressed along z between smooth walls, for a second
/// at most: what `tamp check` knows of a material it learns from this.
struct MaterialTrial {
  struct State {
    double relative_density; ///< [-]
    double axial_pressure;   ///< [Pa]
    double bytes;            ///< that it takes, as stored
  };
  /// The start and the state after each step; ends when the powder is nearly
  /// solid, the time is over or the material fails.
  std::vector<State> states;
  double increment = 0;        ///< logarithmic strain of a step [-]
  double seconds_per_step = 0; ///< mean
  std::string problem;         ///< of a material that failed; else empty
  bool out_of_time = false;

  /// @name Of unit cells only
  /// @{
  std::size_t grains = 0; ///< of the cell tried, 200 at most; 0: a continuum
  double packing_seconds = 0;
  double evaluations_per_step = 0; ///< of all contact forces, mean
  double rayleigh_time_step = 0;   ///< of the smallest grain, scaled [s]
  dem::DynamicMeasures measures;   ///< at the start
  std::vector<dem::Remark> remarks;
  /// @}

  /// Density at which the axial pressure is first met; none if it was not.
  std::optional<double> density_at(double axial_pressure) const;
  /// Of the first state that is as dense, or of the last one [B].
  double bytes_at(double relative_density) const;
};

/// Presses a point in steps of this strain. Dynamics, whose cost is
/// proportional to strain, takes smaller ones. Throws what make_material()
/// throws.
MaterialTrial try_material(const coupling::MaterialChoice &choice,
                           double increment);
} // namespace tamp::apps

#endif
