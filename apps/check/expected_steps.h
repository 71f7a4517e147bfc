// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_check_expected_steps_h
#define apps_check_expected_steps_h

#include <apps/check/material_trial.h>
#include <apps/input/probe_path.h>
#include <fem/die_settings.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// What a stage is expected to take, roughly.
struct ExpectedStage {
  std::string text; ///< the stage in words
  double steps = 0;
  double relative_density = 0; ///< mean, at its end; 0: not known
  std::string doubt;           ///< of what the stage asks for; or empty
};

/// What a schedule starts from.
struct FilledDie {
  double height = 0;     ///< of the powder [m]
  double punch_area = 0; ///< [m2]
};

/// The stages of a die. Densities are met as if the powder were pressed between
/// smooth walls, as the trial was; what unloads is a guess.
std::vector<ExpectedStage> expected_stages(const fem::DieSettings &die,
                                           const FilledDie &filled,
                                           const MaterialTrial &trial);

/// The stages of a probe.
std::vector<ExpectedStage> expected_stages(const ProbePath &path);

/// All of them together.
double sum_of_steps(const std::vector<ExpectedStage> &stages);
} // namespace tamp::apps

#endif
