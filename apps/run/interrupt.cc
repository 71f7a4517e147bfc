// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run/interrupt.h>

#include <csignal>

namespace tamp::apps
{
namespace
{
// The one place where state is global: a signal handler can reach nothing
// else.
volatile std::sig_atomic_t caught = 0, checkpoints = 0;

extern "C" void note_signal(int signal)
{
  caught = signal;
  std::signal(signal, SIG_DFL);
}

extern "C" void note_checkpoint(int)
{
  checkpoints = checkpoints + 1;
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
} // namespace tamp::apps
