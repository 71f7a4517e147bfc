// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_mpi_run_h
#define apps_run_mpi_run_h

#include <fem/ranks.h>

#include <functional>

namespace tamp::apps
{
/// Does the work of a run on all ranks that mpirun started, with MPI and the
/// libraries above it up, and gives the program's exit code: on all ranks the
/// largest that the work gave on any. Exceptions end the work, see end_of().
///
/// The work is the same on all ranks, so that they end it together. If one is
/// alone in ending it with an error (a full disk, no memory), then it says why
/// and ends the others, which wait for it, by MPI_Abort with its exit code.
/// What the work holds lives until then, even if it throws: to destroy what is
/// shared among ranks needs them all. SIGINT and SIGTERM are watched, see
/// caught_signal().
int run_under_mpi(std::function<int(const fem::Ranks &)> work);

/// Does work that is not the same on all ranks and may throw on some: then all
/// throw what says the same as the exception of the first of them, and ends the
/// run alike.
void together(const fem::Ranks &ranks, const std::function<void()> &work);

/// How many ranks, this one included, may use the same cores as this one. Those
/// to which mpirun gave cores of their own do not count. Collective.
unsigned ranks_on_these_cores(const fem::Ranks &ranks);
} // namespace tamp::apps

#endif
