// SPDX-License-Identifier: BSD-3-Clause
#include <apps/command_options.h>
#include <apps/commands.h>
#include <apps/input/nearest_name.h>
#include <apps/input/units.h>
#include <apps/probe/probe_replicas.h>
#include <apps/run/build_facts.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <string>
#include <vector>

namespace
{
using namespace tamp::apps;

void add_run_options(CLI::App &command, RunOptions &options)
{
  add_input_options(command, options);
  add_output_options(command, "results/<name of the input>", options);
}

// One message for every way to go wrong, and its exit code. Of several ranks
// the first one speaks.
int fail(ExitCode code, const std::string &message)
{
  if (number_of_launcher("OMPI_COMM_WORLD_RANK", "PMI_RANK") == 0)
    fmt::print(stderr, "tamp: {}\n", message);
  return code;
}

void add_die(CLI::App &app, RunOptions &options, int &code)
{
  CLI::App *die = app.add_subcommand("die", "Press a powder in a die");
  add_run_options(*die, options);
  die->add_flag("--resume",
                options.resume,
                "Go on from the newest good checkpoint in the folder")
      ->excludes("--force");
  die->callback([&] { code = run_die(options); });
}

void add_pack(CLI::App &app, RunOptions &options, int &code)
{
  CLI::App *pack = app.add_subcommand("pack", "Make packings of grains");
  add_run_options(*pack, options);
  pack->callback([&] {
    expect_one_rank("pack");
    code = run_pack(options);
  });
}

void add_contact(CLI::App &app, RunOptions &options, int &code)
{
  CLI::App *contact = app.add_subcommand(
      "contact", "Take a pair of grains along a path or through an impact");
  add_run_options(*contact, options);
  contact->callback([&] {
    expect_one_rank("contact");
    code = run_contact(options);
  });
}

void add_check(CLI::App &app, RunOptions &options, int &code)
{
  CLI::App *check =
      app.add_subcommand("check", "Read and judge an input without running it");
  add_input_options(*check, options);
  check->callback([&] {
    expect_one_rank("check");
    code = check_input(options);
  });
}

void add_inspect(CLI::App &app,
                 PointChoice &choice,
                 RunOptions &options,
                 int &code)
{
  CLI::App *inspect = app.add_subcommand(
      "inspect", "Look into one material point of a die's unit cells");
  inspect->add_option("RESULT", choice.folder, "Folder of a run of tamp die")
      ->required();
  inspect->add_option(
      "--cell", choice.cell, "Cell of the mesh, 'cell' in the .vtu files");
  inspect
      ->add_option("--point",
                   choice.point,
                   "Point, 'point' in the .vtu files; with --cell also its "
                   "number in the cell")
      ->required();
  inspect->add_option("--step",
                      choice.step,
                      "Step whose grains are written, or all; default: the "
                      "last one");
  add_output_options(*inspect, "RESULT/inspect/cell_<C>_point_<Q>", options);
  inspect->callback([&] {
    expect_one_rank("inspect");
    code = inspect_point(choice, options);
  });
}

void add_probe(CLI::App &app,
               RunOptions &options,
               ReplicaChoice &replicas,
               int &code)
{
  CLI::App *probe =
      app.add_subcommand("probe", "Take one material point along a path");
  add_run_options(*probe, options);
  probe
      ->add_flag("--resume",
                 options.resume,
                 "Go on from the newest good checkpoint in the folder; of "
                 "--replicas and --sizes each cell from its own")
      ->excludes("--force");
  probe->add_option("--replicas",
                    replicas.replicas,
                    "Cells of so many seeds, their mean and scatter");
  probe
      ->add_option("--sizes",
                   replicas.sizes,
                   "Cells of so many grains, divided by commas")
      ->delimiter(',');
  probe->callback([&] {
    if (!replicas.wanted())
      expect_one_rank("probe without --replicas or --sizes");
    code = replicas.wanted() ? run_replicas(options, replicas)
                             : run_probe(options);
  });
}

struct OtherOptions {
  std::string format = "prm";
  std::filesystem::path check;
  std::string example;
  std::filesystem::path folder = ".";
  RunOptions run;
};

// Commands that print or copy.
void add_other_commands(CLI::App &app, OtherOptions &other, int &code)
{
  CLI::App *params = app.add_subcommand(
      "params", "Print all parameters with default, unit and meaning");
  params->add_option("--format", other.format, "prm, json or md")
      ->check(CLI::IsMember({"prm", "json", "md"}));
  params->add_option(
      "--check", other.check, "Read this input instead, without running it");
  params->callback([&] {
    code = other.check.empty() ? print_parameters(other.format)
                               : check_parameters(other.check);
  });

  CLI::App *examples = app.add_subcommand("examples", "Inputs to start from");
  examples->require_subcommand(1);
  examples->add_subcommand("list", "Names and titles")->callback([&] {
    code = list_examples();
  });
  CLI::App *copy = examples->add_subcommand("copy", "Copy an example");
  copy->add_option("NAME", other.example, "Which")->required();
  copy->add_option("DIR", other.folder, "Where to; default: here");
  copy->callback([&] {
    expect_one_rank("examples copy");
    code = copy_example(other.example, other.folder);
  });
  CLI::App *run = examples->add_subcommand(
      "run", "Run an example: its run.sh, or its input");
  run->add_option("NAME", other.example, "Which")->required();
  run->add_option("-o,--output",
                  other.run.output,
                  "Folder for results; default results/NAME");
  run->add_flag("--force",
                other.run.force,
                "Overwrite the results in an existing folder");
  run->callback([&] {
    expect_one_rank("examples run");
    code = run_example(other.example, other.run);
  });
}

// Throws InputError if the first word is neither a command nor an option.
void check_command(const CLI::App &app, int argc, char **argv)
{
  std::vector<std::string> commands;
  for (const CLI::App *command : app.get_subcommands({}))
    commands.push_back(command->get_name());
  const std::string all = fmt::format("{}", fmt::join(commands, ", "));
  if (argc < 2)
    throw InputError(
        fmt::format("expected a command: {}; 'tamp --help' says more", all));
  const std::string word = argv[1];
  if (!word.starts_with('-') && !std::ranges::count(commands, word))
    throw InputError(fmt::format("there is no command '{}'; did you mean "
                                 "'{}'? Commands are {}",
                                 word,
                                 nearest_name(word, commands),
                                 all));
}

int run(int argc, char **argv)
{
  CLI::App app("Powder die compaction: finite elements whose material points "
               "are cells of grains, or a continuum law.\nExit codes: 0 done, "
               "2 usage or input, 3 did not converge, 4 input/output, 5 a "
               "check failed, 128+signal.",
               "tamp");
  app.set_version_flag("--version", "tamp " + build_facts().version);
  app.require_subcommand(1);
  RunOptions options;
  OtherOptions other;
  int code = exit_done;

  add_die(app, options, code);
  ReplicaChoice replicas;
  add_probe(app, options, replicas, code);
  add_pack(app, options, code);
  add_contact(app, options, code);
  add_check(app, options, code);

  PointChoice choice;
  add_inspect(app, choice, options, code);
  add_compare(app, code);
  add_calibrate(app, code);
  add_fit(app, code);
  add_other_commands(app, other, code);
  add_cite(app, code);
  add_selftest(app, code);

  app.footer("To begin: tamp examples list; tamp examples copy die_default; "
             "tamp die die_default/die_default.prm");

  check_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError &error) {
    if (error.get_exit_code() == 0)
      return app.exit(error);
    return fail(exit_input,
                fmt::format("{}; 'tamp --help' and 'tamp COMMAND --help' say "
                            "more",
                            error.what()));
  }
  return code;
}
} // namespace

int main(int argc, char **argv)
{
  // Where /sys is not mounted, the library that looks for cores would complain
  // on stderr about what a run does not need.
  setenv("HWLOC_HIDE_ERRORS", "2", 0);
  try {
    return run(argc, argv);
  } catch (const InputError &error) {
    return fail(exit_input, error.what());
  } catch (const std::invalid_argument &error) {
    return fail(exit_input, error.what());
  } catch (const OutputError &error) {
    return fail(exit_output, error.what());
  } catch (const std::exception &error) {
    return fail(exit_output, error.what());
  }
}
