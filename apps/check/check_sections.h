// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_check_check_sections_h
#define apps_check_check_sections_h

#include <apps/check/check_report.h>
#include <apps/check/die_trial.h>
#include <apps/check/expected_steps.h>
#include <apps/check/material_trial.h>
#include <apps/input/run_input.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tamp::apps
{
/// @name What `tamp check` says of the parts of an input
/// @{
void say_material(CheckReport &report,
                  const coupling::MaterialChoice &material,
                  const MaterialTrial &trial);
/// A pair of grains, or grain and wall.
void say_pair(CheckReport &report, const RunInput &input);
/// Shape and mesh of the powder.
void say_die(CheckReport &report, const RunInput &input);
/// Where the mesh touches the tools, and where it is inside them.
void say_tools(CheckReport &report, const RunInput &input);
void say_stages(CheckReport &report,
                const std::string &title,
                const std::vector<ExpectedStage> &stages);
/// @}

/// How many unit cells or points a run has, and what it does with them.
struct Workload {
  std::size_t points = 1;
  double steps = 0;
  double increment = 0;        ///< strain of a step [-]
  double updates_per_step = 1; ///< evaluations of all points
  /// The largest mean one that is met; none that is solid: not known [-].
  double relative_density = 1;
  std::size_t packings = 0; ///< that are made; 0: they are read
  unsigned threads = 1;
};

/// @name Memory and time, see CheckReport; `die` is null if there is none
/// @{
/// @param program  what the program holds before it begins [B]
void say_memory(CheckReport &report,
                const RunInput &input,
                const MaterialTrial &trial,
                const Workload &work,
                bool with_die,
                double program);
void say_time(CheckReport &report,
              const RunInput &input,
              const MaterialTrial &trial,
              const Workload &work,
              const DieTrial *die);
/// What this process holds in memory now [B]; 0 if that is not known.
double resident_bytes();
/// @}
} // namespace tamp::apps

#endif
