// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_command_options_h
#define apps_command_options_h

#include <apps/run/run_session.h>

#include <CLI/App.hpp>
#include <string>

namespace tamp::apps
{
/// Adds FILE, --set and --threads, which every command that reads an input has.
/// `options` has to outlive `command`.
void add_input_options(CLI::App &command, RunOptions &options);

/// Adds --output, --force, --quiet, --verbose and --no-plots, which every
/// command that writes a folder has. `options` has to outlive `command`.
void add_output_options(CLI::App &command,
                        const std::string &usual_folder,
                        RunOptions &options);

/// A number from the environment of whichever launcher there is: Open MPI or
/// one that speaks PMI; 0 if there is none.
int number_of_launcher(const char *open_mpi, const char *pmi);

/// Throws InputError on all of several ranks, before anything is written.
void expect_one_rank(const std::string &command);
} // namespace tamp::apps

#endif
