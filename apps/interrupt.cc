// SPDX-License-Identifier: BSD-3-Clause
#include <apps/interrupt.h>

#include <csignal>

namespace tamp::apps
{
namespace
{
// The one place where state is global: a signal handler can reach nothing
// else.
volatile std::sig_atomic_t caught = 0;

extern "C" void note_signal(int signal)
{
  caught = signal;
  std::signal(signal, SIG_DFL);
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
} // namespace tamp::apps
