// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/units.h>
#include <apps/run/interrupt.h>
#include <apps/run/mpi_run.h>
#include <apps/run/run_session.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fmt/format.h>
#include <optional>
#include <sched.h>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tamp::apps
{
namespace
{
using Seconds = std::chrono::duration<double>;

// How long a rank that failed waits for the others to fail, too: the first one
// has said by then why, the others leave it the time to do so.
constexpr Seconds patience_of_first(2), patience_of_others(10);
constexpr Seconds pause(0.01);

// Where ranks meet at the end, apart from all other messages.
class MeetingPlace
{
public:
  explicit MeetingPlace(MPI_Comm ranks) { MPI_Comm_dup(ranks, &here_); }
  ~MeetingPlace() { MPI_Comm_free(&here_); }
  MeetingPlace(const MeetingPlace &) = delete;
  MeetingPlace &operator=(const MeetingPlace &) = delete;

  // The largest code of all ranks; none if they do not come in time. Without
  // patience waits for ever.
  std::optional<int> meet(int code, std::optional<Seconds> patience) const
  {
    int largest = code, done = 0;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallreduce(&code, &largest, 1, MPI_INT, MPI_MAX, here_, &request);
    const auto start = std::chrono::steady_clock::now();
    while (true) {
      MPI_Test(&request, &done, MPI_STATUS_IGNORE);
      if (done != 0)
        return largest;
      if (patience && std::chrono::steady_clock::now() - start > *patience)
        return {};
      std::this_thread::sleep_for(pause);
    }
  }

private:
  MPI_Comm here_ = MPI_COMM_NULL;
};

int end_together(const fem::Ranks &ranks,
                 const MeetingPlace &place,
                 int code,
                 const std::string &problem)
{
  const bool first = ranks.rank() == 0;
  if (first && !problem.empty())
    fmt::print(stderr, "tamp: {}\n", problem);
  // What other ranks end without an exception, all end.
  std::optional<Seconds> patience;
  if (first && code != exit_done)
    patience = patience_of_first;
  if (!first && !problem.empty())
    patience = patience_of_others;
  if (const auto all = place.meet(code, patience))
    return *all;
  if (!first)
    fmt::print(stderr, "tamp: on rank {}: {}\n", ranks.rank(), problem);
  std::fflush(nullptr);
  MPI_Abort(MPI_COMM_WORLD, code);
  return code;
}

[[noreturn]] void throw_again(ExitCode code, const std::string &message)
{
  if (code == exit_input)
    throw InputError(message);
  if (code == exit_output)
    throw OutputError(message);
  throw std::runtime_error(message);
}
} // namespace

void together(const fem::Ranks &ranks, const std::function<void()> &work)
{
  if (ranks.size() == 1)
    return work();
  std::string problem; // its code, then its message
  try {
    work();
  } catch (...) {
    const RunEnd end = end_of(std::current_exception());
    problem = static_cast<char>(end.code) + end.message;
  }
  problem = ranks.first_text(problem);
  if (!problem.empty())
    throw_again(static_cast<ExitCode>(problem.front()), problem.substr(1));
}

unsigned ranks_on_these_cores(const fem::Ranks &ranks)
{
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(
      ranks.communicator(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  const fem::Ranks here(node);
  cpu_set_t own;
  CPU_ZERO(&own);
  unsigned count = 1;
  if (sched_getaffinity(0, sizeof own, &own) == 0) {
    std::vector<char> bytes(sizeof own);
    std::memcpy(bytes.data(), &own, sizeof own);
    const std::vector<char> all = here.join(bytes);
    count = 0;
    for (unsigned rank = 0; rank < here.size(); ++rank)
      count += std::memcmp(&all[rank * sizeof own], &own, sizeof own) == 0;
  }
  MPI_Comm_free(&node);
  return count;
}

int run_under_mpi(std::function<int(const fem::Ranks &)> work)
{
  // PETSc must not see our command line, and no exception may leave while MPI
  // is up.
  std::string name = "tamp";
  char *words[] = {name.data(), nullptr};
  char **arguments = words;
  int count = 1;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(count, arguments, 1);
  const fem::Ranks ranks(MPI_COMM_WORLD);
  const MeetingPlace place(MPI_COMM_WORLD);
  watch_signals();
  int code = exit_done;
  std::string problem;
  try {
    code = work(ranks);
  } catch (...) {
    const RunEnd end = end_of(std::current_exception());
    code = end.code;
    problem = end.message;
  }
  code = end_together(ranks, place, code, problem);
  work = nullptr; // while MPI is up
  return code;
}
} // namespace tamp::apps
