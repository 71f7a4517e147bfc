// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_fit_h
#define apps_fit_fit_h

#include <apps/fit/cap_fit.h>
#include <apps/fit/unloading_moduli.h>
#include <apps/run/run_session.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tamp::apps
{
/// What a user says on the command line of tamp fit.
struct FitRequest {
  /// Of tamp probe, one of several cells stands for all of them; for an
  /// equation of compaction one, also of tamp die.
  std::vector<std::filesystem::path> folders;
  std::string law = "drucker-prager-cap";
  /// None: irreversible strain, or for a cap the peak where that strain comes
  /// before the state on the uniaxial path.
  std::optional<YieldCriterion> criterion;
  ModuliSource moduli = ModuliSource::probes;
};

/// The laws that can be fitted, as --law names them.
std::vector<std::string> fitted_laws();

/// Fits a law to probes and writes its folder. Throws InputError before
/// anything is written if the probes do not suffice.
int run_fit(const FitRequest &request, const RunOptions &options);
/// Likewise equations of compaction, see compaction_equations().
int run_equations(const FitRequest &request, const RunOptions &options);
} // namespace tamp::apps

#endif
