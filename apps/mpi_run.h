// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_mpi_run_h
#define apps_mpi_run_h

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
} // namespace tamp::apps

#endif
