// SPDX-License-Identifier: BSD-3-Clause
#include <apps/command_options.h>
#include <apps/commands.h>
#include <apps/fit.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <string>

namespace tamp::apps
{
void add_fit(CLI::App &app, int &code)
{
  struct Choice {
    FitRequest request;
    RunOptions options;
  };
  const auto choice = std::make_shared<Choice>();
  FitRequest &request = choice->request;
  CLI::App *fit = app.add_subcommand("fit", "Fit a continuum law to probes");
  fit->add_option("FOLDER", request.folders, "Folders of tamp probe")
      ->required();
  fit->add_option("--law", request.law, "Which law")
      ->check(CLI::IsMember(fitted_laws()))
      ->required();
  const std::map<std::string, YieldCriterion> criteria{
      {"strain", YieldCriterion::strain},
      {"work", YieldCriterion::work},
      {"peak", YieldCriterion::peak}};
  fit->add_option("--criterion",
                  request.criterion,
                  "What tells yield in the scans: strain (irreversible), work "
                  "(plastic) or peak; default: strain, or peak for a cap that "
                  "strain does not allow")
      ->transform(CLI::CheckedTransformer(criteria));
  add_output_options(
      *fit, "FOLDER/fit/LAW of the first folder", choice->options);
  fit->callback([choice, &code] {
    expect_one_rank("fit");
    code = run_fit(choice->request, choice->options);
  });
}
} // namespace tamp::apps
