// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_probe_probe_replicas_h
#define apps_probe_probe_replicas_h

#include <apps/run/run_session.h>

#include <mutex>
#include <string>
#include <vector>

namespace tamp::apps
{
/// How often a probe is done, with other grains each time.
struct ReplicaChoice {
  int replicas = 1;        ///< of each size: seeds one after the other
  std::vector<long> sizes; ///< counts of grains; none: that of the input
  bool wanted() const { return replicas != 1 || !sizes.empty(); }
};

/// A probe that is one of several.
struct ProbeMember {
  unsigned replica = 1;          ///< its number among those of its size
  std::mutex *writing = nullptr; ///< held while files of grains are written
};

/// A probe in a folder of its own; returns its exit code.
int run_member(const RunOptions &options, const ProbeMember &member);

/// A probe with packings of several seeds and sizes, as many at once as there
/// are threads on all ranks that mpirun started: a folder for each, which all
/// ranks must be able to reach, and at the top their mean with its band,
/// replicas.csv, and which size suffices. Throws InputError or OutputError.
int run_replicas(const RunOptions &options, const ReplicaChoice &choice);
} // namespace tamp::apps

#endif
