// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run/interrupt.h>

#include <atomic>
#include <csignal>

namespace tamp::apps
{
namespace
{
// The one place where state is global: a signal handler can reach nothing
// else. Threads read it, so that it is atomic; a handler may use it as long as
// it takes no lock.
std::atomic<int> caught = 0, checkpoints = 0;
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void note_signal(int signal)
{
  caught = signal;
  std::signal(signal, SIG_DFL);
}

extern "C" void note_checkpoint(int)
{
  ++checkpoints;
}
} // namespace

void watch_signals()
{
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
}

int caught_signal()
{
  return caught;
}

void watch_checkpoint_signal()
{
  struct sigaction action = {};
  action.sa_handler = note_checkpoint;
  action.sa_flags = SA_RESTART;
  sigaction(SIGUSR1, &action, nullptr);
}

int checkpoint_signals()
{
  return checkpoints;
}

void catch_signals_of_others(int signal, int checkpoint_signals)
{
  int none = 0;
  caught.compare_exchange_strong(none, signal);
  int now = checkpoints;
  while (now < checkpoint_signals &&
         !checkpoints.compare_exchange_weak(now, checkpoint_signals))
    ;
}
} // namespace tamp::apps
