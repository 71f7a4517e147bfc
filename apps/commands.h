// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_commands_h
#define apps_commands_h

#include <apps/die/inspected_run.h>
#include <apps/run/run_session.h>

#include <filesystem>
#include <string>

namespace CLI
{
class App;
}

namespace tamp::apps
{
/// Each function is a command of the program and returns its exit code. Throws
/// InputError or OutputError.

/// A material point along a path.
int run_probe(const RunOptions &options);
/// One pair of grains along a path or through an impact.
int run_contact(const RunOptions &options);
/// Packings of grains.
int run_pack(const RunOptions &options);
/// A compact in a die.
int run_die(const RunOptions &options);
/// One material point out of the run of a die: history, grains, replay. Exit
/// code 5 if the replay gives other stresses than the run.
int inspect_point(const PointChoice &choice, RunOptions options);
/// Adds the command that lays runs of one command side by side.
void add_compare(CLI::App &app, int &code);
/// Adds the command tamp fit, see run_fit(); its exit code goes to `code`.
void add_fit(CLI::App &app, int &code);
/// Reads and judges an input without running it: ranges, mesh, tools, schedule,
/// memory, time. Writes nothing. Exit code 5 if it should not be run.
int check_input(const RunOptions &options);
/// Prints all parameters: "prm", "json" or "md".
int print_parameters(const std::string &format);
/// Reads an input without running it, says what is wrong with it.
int check_parameters(const std::filesystem::path &input);
/// Prints the names of the examples and what they show.
int list_examples();
/// The folder of an example.
std::filesystem::path find_example(const std::string &name);
/// Copies an example to `folder`/NAME.
int copy_example(const std::string &name, const std::filesystem::path &folder);
/// Runs an example: its run.sh, which then takes the place of this process, or
/// its input by the command that this is for. Of `options` only output and
/// force count.
int run_example(const std::string &name, RunOptions options);

/// Commands that register themselves: their exit code comes in `code`.

/// BibTeX entries of tamp and what it, or an input, stands on.
void add_cite(CLI::App &app, int &code);
/// Closed forms of all rooms; exit code 5 if one is missed.
void add_selftest(CLI::App &app, int &code);
/// Fits parameters to a measured curve.
void add_calibrate(CLI::App &app, int &code);
} // namespace tamp::apps

#endif
