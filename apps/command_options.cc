// SPDX-License-Identifier: BSD-3-Clause
#include <apps/command_options.h>
#include <apps/input/units.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <fmt/format.h>

namespace tamp::apps
{
void add_input_options(CLI::App &command, RunOptions &options)
{
  command.add_option("FILE", options.input, "Input, .prm or .json")->required();
  command
      .add_option("--set",
                  options.settings,
                  "\"Section/Name = value\", beats the file; may be repeated")
      ->expected(1)
      ->take_all();
  command.add_option("--threads",
                     options.threads,
                     "Threads; default: all cores this process may use");
}

void add_output_options(CLI::App &command,
                        const std::string &usual_folder,
                        RunOptions &options)
{
  command.add_option("-o,--output",
                     options.output,
                     "Folder for results; default " + usual_folder);
  command.add_flag(
      "--force", options.force, "Overwrite the results in an existing folder");
  command.add_flag_callback(
      "-q,--quiet",
      [&options] { options.verbosity = Verbosity::quiet; },
      "Say nothing but errors");
  command.add_flag_callback(
      "-v,--verbose",
      [&options] { options.verbosity = Verbosity::verbose; },
      "Say everything, without a bar");
  command.add_flag_callback(
      "--no-plots", [&options] { options.plots = false; }, "Draw no plots");
}

int number_of_launcher(const char *open_mpi, const char *pmi)
{
  for (const char *name : {open_mpi, pmi})
    if (const char *text = std::getenv(name); text && *text)
      return std::atoi(text);
  return 0;
}

void expect_one_rank(const std::string &command)
{
  const int count = number_of_launcher("OMPI_COMM_WORLD_SIZE", "PMI_SIZE");
  if (count > 1)
    throw InputError(fmt::format("tamp {} runs on one rank, not on {}; use "
                                 "--threads N instead of mpirun -np N",
                                 command,
                                 count));
}
} // namespace tamp::apps
