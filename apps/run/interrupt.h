// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_interrupt_h
#define apps_run_interrupt_h

namespace tamp::apps
{
/// From now on SIGINT and SIGTERM are noted instead of ending the program; a
/// second one ends it at once.
void watch_signals();

/// The signal that came since watch_signals(), or 0. The step at hand is
/// finished and results are kept; the program then ends with 128 + signal.
int caught_signal();

/// From now on SIGUSR1 is noted instead of ending the program.
void watch_checkpoint_signal();

/// How often SIGUSR1 came: each time it wants a checkpoint of every run at
/// work.
int checkpoint_signals();

/// Has this process know of what another rank's caught_signal() and
/// checkpoint_signals() are, as if it had come here.
void catch_signals_of_others(int signal, int checkpoint_signals);
} // namespace tamp::apps

#endif
