// SPDX-License-Identifier: BSD-3-Clause
#include <apps/command_options.h>
#include <apps/commands.h>
#include <apps/compare/compare_plots.h>
#include <apps/compare/compare_report.h>
#include <apps/input/csv_line.h>
#include <apps/input/units.h>
#include <apps/run/run_log.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <memory>

namespace tamp::apps
{
namespace
{
struct CompareOptions {
  std::vector<std::filesystem::path> folders;
  std::string names; ///< divided by commas; empty: those of the folders
  RunOptions run;    ///< its folder, --force and the like
};

// What neither CSV nor gnuplot can be told.
bool is_allowed(char letter)
{
  return static_cast<unsigned char>(letter) >= ' ' &&
         std::string_view(",\"'`\\%#").find(letter) == std::string_view::npos;
}

std::string folder_name(const std::filesystem::path &folder)
{
  const auto whole = std::filesystem::absolute(folder).lexically_normal();
  std::string name =
      whole.has_filename() ? whole.filename() : whole.parent_path().filename();
  std::ranges::replace_if(name, std::not_fn(is_allowed), '_');
  return name;
}

std::vector<std::string> names_of(const CompareOptions &options)
{
  std::vector<std::string> names;
  if (!options.names.empty()) {
    names = fields_of(options.names);
  } else {
    for (const auto &folder : options.folders)
      names.push_back(folder_name(folder));
    for (std::size_t i = 0; i < names.size(); ++i)
      if (std::ranges::count(names, names[i]) > 1)
        for (std::size_t k = names.size(), last = i; k-- > last;)
          if (k > i && names[k] == names[i])
            names[k] += fmt::format(" ({})", k + 1);
  }
  if (names.size() != options.folders.size())
    throw InputError(fmt::format("--names: expected {} names divided by "
                                 "commas, one for each folder, found {}",
                                 options.folders.size(),
                                 names.size()));
  for (const std::string &name : names)
    if (name.empty() || !std::ranges::all_of(name, is_allowed) ||
        std::ranges::count(names, name) > 1)
      throw InputError(
          fmt::format("--names: '{}': expected names that differ, without "
                      "quotes, backslash, % or #",
                      name));
  return names;
}

std::vector<ResultFolder> read_runs(const CompareOptions &options)
{
  if (options.folders.size() < 2)
    throw InputError(fmt::format("'{}' is only one folder; expected at least "
                                 "two, the first one the reference",
                                 options.folders.front().string()));
  const std::vector<std::string> names = names_of(options);
  std::vector<ResultFolder> runs;
  for (std::size_t i = 0; i < names.size(); ++i) {
    runs.push_back(read_result_folder(options.folders[i], names[i]));
    const ResultFolder &run = runs.back(), &first = runs.front();
    if (run.command != first.command)
      throw InputError(fmt::format(
          "'{}' is a run of tamp {}, '{}' one of tamp {}: expected runs of one "
          "command, they have no curves in common",
          first.path.string(),
          first.command,
          run.path.string(),
          run.command));
  }
  for (ResultFolder &run : runs)
    add_derived_columns(run);
  return runs;
}

// What to mind before one reads on.
std::vector<std::string> warnings_of(const std::vector<ResultFolder> &runs)
{
  std::vector<std::string> warnings;
  for (const ResultFolder &run : runs) {
    if (!run.finished())
      warnings.push_back(fmt::format(
          "{} did not finish (status '{}'{}); what it has is compared",
          run.name,
          run.status,
          run.message.empty() ? "" : ": " + run.message));
    if (run.command == "die" && run.fields.empty())
      warnings.push_back(fmt::format(
          "{} has no fields.pvd: fields of no run are compared", run.name));
  }
  const std::size_t common = common_stages(runs);
  std::size_t most = 0;
  for (const ResultFolder &run : runs)
    most = std::max(most, run.curve.stages().size());
  if (common < most)
    warnings.push_back(fmt::format("{} of at most {} stages are of one kind in "
                                   "all runs and compared",
                                   common,
                                   most));
  return warnings;
}

// Dies that do not hold the same powder.
void warn_of_powder(Comparison &comparison)
{
  const ComparedState &state = comparison.states.front();
  for (std::size_t run = 1; run < comparison.runs.size(); ++run) {
    const double excess = state.others[run - 1].mass / state.reference_mass - 1;
    if (std::abs(excess) > 1e-3)
      comparison.warnings.push_back(
          fmt::format("{} holds {:.2g} % {} powder than {}",
                      comparison.runs[run].name,
                      100 * std::abs(excess),
                      excess > 0 ? "more" : "less",
                      comparison.runs.front().name));
  }
}

Comparison compare_runs(const CompareOptions &options)
{
  Comparison comparison;
  comparison.runs = read_runs(options);
  comparison.warnings = warnings_of(comparison.runs);
  comparison.curves = compare_curves(comparison.runs);
  if (comparison.curves.empty())
    comparison.warnings.emplace_back(
        "no curve has a range in common with the reference");
  const bool fields =
      std::ranges::none_of(comparison.runs, [](const ResultFolder &run) {
        return run.fields.empty();
      });
  if (fields)
    for (const CommonState &state : common_states(comparison.runs))
      comparison.states.push_back(compare_fields(state));
  if (!comparison.states.empty())
    warn_of_powder(comparison);
  return comparison;
}

std::string draw(const RunFolder &folder, const Comparison &comparison)
{
  const auto place = folder.subfolder("plots");
  write_curves(place, comparison.runs);
  std::vector<Plot> plots = compared_curve_plots(comparison.runs);
  for (Plot &map : write_maps(place, comparison.states, comparison.runs))
    plots.push_back(std::move(map));
  return draw_plots(place, plots, {"svg", "png"});
}

// What run.json keeps of a run's difference from the reference.
std::vector<std::pair<std::string, double>>
outcome(const Comparison &comparison, std::size_t run)
{
  std::vector<std::pair<std::string, double>> results;
  for (const auto &norms :
       {curve_norms(comparison.curves), field_norms(comparison.states)})
    for (const ComparedQuantity &norm : norms)
      if (!std::isnan(norm.values[run]) &&
          (norm.name.ends_with("relative_L2_difference[-]") ||
           norm.name.find("root_mean_square") != std::string::npos ||
           norm.name.find("difference_of_maps") != std::string::npos))
        results.emplace_back(norm.name, norm.values[run]);
  return results;
}

RunRecord record_of(const CompareOptions &options)
{
  RunRecord record;
  record.command = "compare";
  for (const auto &folder : options.folders) {
    record.input_echo += folder.string() + "\n";
    record.folders.push_back(folder);
  }
  record.input = options.folders.front();
  return record;
}

int write(const CompareOptions &options,
          RunRecord &record,
          const Comparison &comparison)
{
  std::vector<std::filesystem::path> needed;
  for (const ResultFolder &run : comparison.runs)
    needed.push_back(run.path / "run.json");
  const RunFolder folder(options.run.output, options.run.force, needed);
  RunLog log(options.run.output / "log.txt", options.run.verbosity);
  record.warnings = comparison.warnings;
  for (const std::string &warning : comparison.warnings)
    log.warn(warning);
  folder.write("compare.csv", comparison_table(comparison));
  std::vector<std::string> names;
  for (const ResultFolder &run : comparison.runs)
    names.push_back(run.name);
  if (!comparison.states.empty())
    write_differences(
        folder.path() / "difference.vtu", comparison.states, names);
  if (options.run.plots)
    if (const std::string problem = draw(folder, comparison); !problem.empty())
      log.warn(problem);
  for (std::size_t run = 1; run < names.size(); ++run)
    for (const auto &[name, value] : outcome(comparison, run))
      record.results.emplace_back(names[run] + ": " + name, value);
  record.status = "done";
  const std::string summary = comparison_summary(comparison);
  folder.write("summary.txt", summary);
  folder.write("run.json", record.json());
  log.say(summary);
  log.say(fmt::format("Results are in {}", folder.path().string()));
  return exit_done;
}

int compare(const CompareOptions &options)
{
  RunRecord record = record_of(options);
  const Comparison comparison = compare_runs(options);
  return write(options, record, comparison);
}
} // namespace

void add_compare(CLI::App &app, int &code)
{
  auto options = std::make_shared<CompareOptions>();
  options->run.output = "results/compare";
  CLI::App *command = app.add_subcommand(
      "compare", "Lay runs of one command side by side: curves, fields, cost");
  command
      ->add_option("FOLDER",
                   options->folders,
                   "Folders of runs of tamp die, probe, pack or contact; the "
                   "first one is the reference")
      ->required();
  command->add_option(
      "--names",
      options->names,
      "What the runs are called, A,B,..; default: their folders");
  add_output_options(*command, "results/compare", options->run);
  command->callback([options, &code] {
    expect_one_rank("compare");
    code = compare(*options);
  });
}
} // namespace tamp::apps
