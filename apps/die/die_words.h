// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_die_words_h
#define apps_die_die_words_h

#include <apps/die/die_results.h>
#include <fem/die_model.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// What stands above the curve: the signs, and a line for each stage.
std::vector<std::string> stage_remarks(const fem::DieSettings &settings);

/// Share of all steps that is done, roughly: for the time left.
double share_done(const fem::DieSettings &settings,
                  const fem::StepRecord &record);

/// What log and terminal say of a step.
/// @param effort  null for continua.
std::string step_line(const fem::StepRecord &record,
                      fem::StageKind kind,
                      const StepEffort *effort);

/// Why a die could not go on after a step, where, and what may help.
std::string failure_words(const fem::Failure &failure,
                          unsigned step,
                          fem::StageKind kind,
                          bool cells);
} // namespace tamp::apps

#endif
