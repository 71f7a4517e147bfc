// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/calibrate.h>
#include <apps/command_options.h>
#include <apps/commands.h>

#include <CLI/CLI.hpp>
#include <memory>

namespace tamp::apps
{
namespace
{
struct CalibrateOptions {
  CalibrationChoice choice;
  RunOptions run;
};

void add_reference(CLI::App &command, CalibrationChoice &choice)
{
  command.add_option("--density-at-start",
                     choice.density_at_start,
                     "Relative density of the powder at the displacement 0, or "
                     "at the first height of the data");
  command.add_option("--height-at-start",
                     choice.height_at_start,
                     "Height of the powder at the displacement 0");
  command.add_option(
      "--area", choice.area, "Of the punch, if the data have a force");
}
} // namespace

void add_calibrate(CLI::App &app, int &code)
{
  auto options = std::make_shared<CalibrateOptions>();
  CLI::App *calibrate = app.add_subcommand(
      "calibrate", "Fit parameters to a measured compaction curve");
  add_input_options(*calibrate, options->run);
  CalibrationChoice &choice = options->choice;
  calibrate
      ->add_option("--data",
                   choice.data,
                   "CSV: relative_density[-], density[g/cm3], height[mm] or "
                   "displacement[mm]; pressure[MPa] or force[kN]; perhaps "
                   "lateral_pressure[MPa]")
      ->required();
  calibrate
      ->add_option("--fit",
                   choice.fits,
                   "\"Section/Name = LOW .. HIGH\"; may be repeated")
      ->required()
      ->expected(1)
      ->take_all();
  calibrate->add_option("--with", choice.model, "What simulates: probe or die")
      ->check(CLI::IsMember({"probe", "die"}));
  calibrate->add_option("--runs",
                        choice.most_runs,
                        "At most so many; default: 20 for each parameter, and "
                        "20 more");
  calibrate
      ->add_option("--packings",
                   choice.packings,
                   "Of unit cells, whose mean is fitted at the end; their "
                   "scatter is in the errors; default 7; probe only")
      ->check(CLI::Range(1u, 1000u));
  add_reference(*calibrate, choice);
  add_output_options(*calibrate, "results/<name of the input>", options->run);
  calibrate
      ->add_flag("--resume",
                 options->run.resume,
                 "Go on with the calibration in the folder")
      ->excludes("--force");
  calibrate->callback([options, &code] {
    expect_one_rank("calibrate");
    code = apps::calibrate(options->choice, options->run);
  });
}
} // namespace tamp::apps
