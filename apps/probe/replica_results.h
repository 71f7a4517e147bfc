// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_probe_replica_results_h
#define apps_probe_replica_results_h

#include <apps/run/run_session.h>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tamp::apps
{
/// One of several probes along the same path, and how it ended.
struct Replica {
  long size = 0; ///< grains
  std::uint64_t seed = 0;
  unsigned number = 1; ///< among those of its size
  std::filesystem::path folder;
  ExitCode code = exit_done;
};

/// Reads the folders of probes, by size, then by seed, and gives the session
/// what they tell together: replicas.csv, the mean of those of the largest size
/// in curve.csv, yield.csv and moduli.csv, peaks with their scatter, the size
/// that suffices, plots. Probes that broke off count as far as they came, but
/// not among the peaks. Throws OutputError.
void give_replicas(RunSession &session, const std::vector<Replica> &replicas);
} // namespace tamp::apps

#endif
