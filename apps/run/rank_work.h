// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_rank_work_h
#define apps_run_rank_work_h

#include <apps/run/run_session.h>
#include <fem/ranks.h>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace tamp::apps
{
/// Pieces of work that ranks do apart from each other, such as whole probes.
struct RankWork {
  std::vector<std::size_t> order; ///< a permutation of 0, 1, ...: longest first
  unsigned threads = 1;           ///< of this rank
  /// Does a piece, on one rank, in a thread that must not use MPI.
  std::function<RunEnd(std::size_t piece)> work;
  /// Hears on all ranks, in the thread that calls, which rank has done a piece.
  std::function<void(std::size_t piece, unsigned rank)> done;
};

/// Does all pieces, on as many threads as the ranks have together: each takes
/// the next one as it becomes free. Collective; the ranks may have different
/// numbers of threads, all else is the same. Returns on all ranks how the
/// pieces ended; one that throws has ended by end_of(). SIGINT, SIGTERM and
/// SIGUSR1 that one rank catches meanwhile all catch.
std::vector<RunEnd> share_among_ranks(const fem::Ranks &ranks,
                                      const RankWork &shared);
} // namespace tamp::apps

#endif
