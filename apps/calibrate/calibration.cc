// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/calibration.h>
#include <apps/run/input_table.h>
#include <coupling/work_sharing.h>

#include <fmt/format.h>
#include <mutex>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
std::string settings_words(const std::vector<FitParameter> &parameters,
                           const std::vector<double> &values)
{
  std::string words;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string &path = parameters[i].path;
    words +=
        fmt::format("{}{} {:.4g}{}",
                    i > 0 ? ", " : "",
                    path.substr(path.rfind('/') + 1),
                    values[i],
                    parameters[i].unit == "-" ? "" : " " + parameters[i].unit);
  }
  return words;
}

std::vector<std::string> joined(const std::vector<std::string> &first,
                                const std::vector<std::string> &second)
{
  std::vector<std::string> all = first;
  all.insert(all.end(), second.begin(), second.end());
  return all;
}

std::vector<std::string>
settings_at(const std::vector<FitParameter> &parameters,
            const Eigen::VectorXd &place)
{
  std::vector<std::string> settings;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    settings.push_back(
        parameters[i].setting(place[static_cast<Eigen::Index>(i)]));
  return settings;
}
} // namespace

RunInput CalibrationInput::read(const std::vector<std::string> &values) const
{
  RunOptions with = options;
  with.settings = joined(joined(options.settings, shared), values);
  ParameterTable table;
  read_table(with, table);
  RunInput input = read_input(table, need);
  input.material.threads = 1;
  return input;
}

RunInput CalibrationInput::at(const CalibrationPlace &at) const
{
  auto settings = settings_at(parameters, at.place);
  if (!of_packing.empty())
    settings = joined(settings, of_packing[at.packing]);
  return read(settings);
}

RunInput CalibrationInput::base(unsigned packing) const
{
  return read(of_packing.empty() ? std::vector<std::string>()
                                 : of_packing[packing]);
}

std::string CalibrationInput::echo(const Eigen::VectorXd &place,
                                   const std::string &packings) const
{
  RunOptions with = options;
  with.settings =
      joined(joined(options.settings, shared), settings_at(parameters, place));
  if (!of_packing.empty())
    with.settings = joined(with.settings, of_packing[0]);
  ParameterTable table;
  read_table(with, table);
  name_files_in_full(table);
  if (!packings.empty())
    table.set("Packing/File = " + packings);
  std::ostringstream text;
  table.echo(text);
  return text.str();
}

std::vector<double> CalibrationInput::values(const Eigen::VectorXd &place) const
{
  std::vector<double> values;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    values.push_back(parameters[i].value(place[static_cast<Eigen::Index>(i)]));
  return values;
}

/// Runs at some places. Those at the front that are ready are in the file.
struct CalibrationRuns::Batch {
  std::vector<std::optional<RunInput>> inputs; ///< of runs to be made
  std::vector<CalibrationRun> runs;
  std::vector<std::string> problems;
  std::vector<bool> ready;
  std::size_t written = 0;
  std::mutex turn;
};

CalibrationRuns::CalibrationRuns(RunSession &session,
                                 const CalibrationInput &input,
                                 const CurveSimulator &simulator,
                                 const CurveTargets &targets,
                                 CalibrationFile &file,
                                 std::size_t most_runs)
    : session_(session), input_(input), simulator_(simulator),
      targets_(targets), file_(file), most_runs_(most_runs)
{
}

std::vector<Eigen::VectorXd>
CalibrationRuns::evaluate(const std::vector<CalibrationPlace> &places,
                          RunKind kind)
{
  Batch batch;
  const std::size_t count = places.size();
  batch.inputs.resize(count);
  batch.runs.resize(count);
  batch.problems.resize(count);
  batch.ready.assign(count, false);
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < count; ++k) {
    batch.runs[k] = {
        kind, places[k].packing, input_.values(places[k].place), {}};
    if (const auto stored = file_.stored(runs_ + k, batch.runs[k].values)) {
      batch.runs[k] = *stored;
      batch.ready[k] = true;
      continue;
    }
    open.push_back(k);
    try {
      batch.inputs[k] = input_.at(places[k]);
    } catch (const InputError &error) {
      batch.problems[k] = error.what();
    }
  }
  write(batch);
  const bool dies = simulator_.model() == CurveSimulator::Model::die;
  for (auto &input : batch.inputs)
    if (input && dies)
      input->material.threads = session_.threads();
  coupling::share_work(open, dies ? 1 : session_.threads(), [&](std::size_t k) {
    make(batch, k);
  });
  if (failed_ == runs_ && !batch.problems.back().empty())
    throw std::runtime_error(
        fmt::format("all {} runs failed; of the last one: {}",
                    runs_,
                    batch.problems.back()));
  std::vector<Eigen::VectorXd> residuals;
  for (const CalibrationRun &run : batch.runs)
    residuals.push_back(run.residuals);
  return residuals;
}

void CalibrationRuns::make(Batch &batch, std::size_t k)
{
  CalibrationRun &run = batch.runs[k];
  if (batch.inputs[k]) {
    const SimulatedCurve simulated = simulator_.run(*batch.inputs[k]);
    batch.problems[k] = simulated.problem;
    if (simulated.problem.empty()) {
      const auto found = targets_.residuals(simulated.curve);
      if (!found)
        batch.problems[k] = targets_.reach(simulated.curve);
      else
        run.residuals = Eigen::Map<const Eigen::VectorXd>(
            found->data(), static_cast<Eigen::Index>(found->size()));
    }
  }
  const std::lock_guard lock(batch.turn);
  batch.ready[k] = true;
  write(batch);
}

// Runs go to the file in their order, whichever was ready first.
void CalibrationRuns::write(Batch &batch)
{
  while (batch.written < batch.runs.size() && batch.ready[batch.written]) {
    const CalibrationRun &run = batch.runs[batch.written];
    file_.write(run);
    ++runs_;
    say(run, batch.problems[batch.written]);
    ++batch.written;
  }
}

void CalibrationRuns::say(const CalibrationRun &run, const std::string &problem)
{
  std::string words = fmt::format(
      "run {:3d}  {}", runs_, settings_words(input_.parameters, run.values));
  if (run.residuals.size() == 0) {
    ++failed_;
    words += "  failed" + (problem.empty() ? "" : ": " + problem);
  } else {
    const double misfit = misfit_of(
        {run.residuals.data(), static_cast<std::size_t>(run.residuals.size())});
    if (best_ <= 0 || misfit < best_)
      best_ = misfit;
    words += fmt::format("  misfit {:.4g}  best {:.4g}", misfit, best_);
  }
  session_.log().step(static_cast<double>(runs_) /
                          static_cast<double>(most_runs_),
                      static_cast<double>(runs_),
                      "runs",
                      words);
}
} // namespace tamp::apps
