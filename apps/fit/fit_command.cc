// SPDX-License-Identifier: BSD-3-Clause
#include <apps/command_options.h>
#include <apps/commands.h>
#include <apps/fit/equation_report.h>
#include <apps/fit/fit.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

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
  CLI::App *fit = app.add_subcommand(
      "fit", "Fit a continuum law, or equations of compaction, to probes");
  fit->add_option("FOLDER",
                  request.folders,
                  "Folders of tamp probe; for equations one of probe or die")
      ->required();
  const std::vector<std::string> equations = compaction_equations();
  std::vector<std::string> laws = fitted_laws();
  laws.insert(laws.end(), equations.begin(), equations.end());
  fit->add_option("--law", request.law, "Which law or equation")
      ->check(CLI::IsMember(laws))
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
      ->transform(CLI::CheckedTransformer(criteria).description(
          "one of strain, work, peak"));
  const std::map<std::string, ModuliSource> sources{
      {"probes", ModuliSource::probes}, {"unloading", ModuliSource::unloading}};
  fit->add_option("--moduli",
                  request.moduli,
                  "Where elasticity comes from: small probes (default), right "
                  "as unloading begins, or secants of the whole unloading of "
                  "the uniaxial path, for what dies keep and give back")
      ->transform(CLI::CheckedTransformer(sources).description(
          "one of probes, unloading"));
  add_output_options(
      *fit, "FOLDER/fit/LAW of the first folder", choice->options);
  fit->callback([choice, equations, &code] {
    expect_one_rank("fit");
    const bool of_compaction =
        std::ranges::count(equations, choice->request.law) > 0;
    code = (of_compaction ? run_equations : run_fit)(choice->request,
                                                     choice->options);
  });
}
} // namespace tamp::apps
