// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_schedule_h
#define apps_input_schedule_h

#include <fem/die_settings.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// What a schedule refers to without saying it.
struct ScheduleContext {
  double punch_area = 0;         ///< [m2]
  double default_hold_share = 0; ///< of an ejection that says nothing [-]
};

/// Reads stages divided by semicolons:
///   press [upper|lower|both] to density D | to displacement L | to force F
///     | to pressure P; it says nothing: the upper punch
///   unload to R % of peak | to force F | to pressure P | to nothing | by L
///   eject to rim | to out | by L, then, in any order: holding R % of peak or
///     freely; by withdrawal
///   hold N steps
/// Throws InputError naming the stage and the word.
std::vector<fem::Stage> parse_schedule(const std::string &stages,
                                       const ScheduleContext &context);

/// "press", "unload", "eject", "hold".
std::string name_of(fem::StageKind kind);
} // namespace tamp::apps

#endif
