// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/inspected_run.h>
#include <apps/die/trial_recorder.h>
#include <apps/run/input_table.h>
#include <apps/run/run_folder.h>
#include <apps/run/run_resume.h>

#include <charconv>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
// Throws InputError if the folder has no points that could have been recorded.
void check_run(const std::filesystem::path &folder)
{
  const std::string command = RunFolder::existing(folder).command();
  if (command != "die")
    throw InputError(fmt::format("'{}' is the folder of tamp {}; expected one "
                                 "of tamp die with unit cells",
                                 folder.string(),
                                 command));
  RunOptions options;
  options.input = folder / "input.prm";
  ParameterTable table;
  read_table(options, table);
  const std::string material = table.word("Material/Type");
  if (material != "unit cell")
    throw InputError(fmt::format(
        "'{}' is the run of a continuum, Material/Type = {}: the histories of "
        "single points are kept of unit cells only",
        folder.string(),
        material));
}
} // namespace

InspectedRun::InspectedRun(const PointChoice &choice) : folder_(choice.folder)
{
  check_run(folder_);
  const auto file = folder_ / TrialRecorder::name;
  if (!std::filesystem::exists(file))
    throw InputError(fmt::format(
        "'{}' is missing: the run is of an earlier version, or could not write "
        "it, as its log.txt then says",
        file.string()));
  trials_.emplace(file);
  const std::string difference = differences(input_in(folder_), title().input);
  if (!difference.empty())
    throw InputError(fmt::format(
        "'{}' was changed since the run: {}", input().string(), difference));
  find_point(choice);
  find_step(choice);
}

void InspectedRun::find_point(const PointChoice &choice)
{
  const auto points = static_cast<long>(title().points);
  const auto per_cell = static_cast<long>(title().points_per_cell);
  const auto cells = points / per_cell;
  const long point = choice.point;
  if (!choice.cell) {
    if (point < 0 || point >= points)
      throw InputError(fmt::format("--point {}: there is no such point; "
                                   "expected a number from 0 to {}",
                                   point,
                                   points - 1));
    point_ = static_cast<std::size_t>(point);
    return;
  }
  const long cell = *choice.cell;
  if (cell < 0 || cell >= cells)
    throw InputError(fmt::format("--cell {}: there is no such cell of the "
                                 "mesh; expected a number from 0 to {}",
                                 cell,
                                 cells - 1));
  const long first = cell * per_cell;
  const bool own = point >= 0 && point < per_cell;
  if (!own && (point < first || point >= first + per_cell))
    throw InputError(fmt::format(
        "--point {}: cell {} has no such point; expected a number from 0 to {}"
        "{}",
        point,
        cell,
        per_cell - 1,
        cell == 0 ? ""
                  : fmt::format(" or, among all points, from {} to {}",
                                first,
                                first + per_cell - 1)));
  point_ = static_cast<std::size_t>(own ? first + point : point);
}

void InspectedRun::find_step(const PointChoice &choice)
{
  if (steps() == 0)
    throw InputError(fmt::format("'{}' has no step yet",
                                 (folder_ / TrialRecorder::name).string()));
  const std::size_t last = steps() - 1;
  const bool failed = last > 0 && !step(last).accepted;
  last_accepted_ = failed ? last - 1 : last;
  wanted_ = static_cast<unsigned>(last_accepted_);
  if (choice.step == "all")
    wanted_.reset();
  if (choice.step.empty() || choice.step == "all")
    return;
  unsigned number = 0;
  const char *end = choice.step.data() + choice.step.size();
  const auto read = std::from_chars(choice.step.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end || number > last_accepted_)
    throw InputError(fmt::format("--step {}: there is no such step; expected "
                                 "a number from 0 to {}, or all",
                                 choice.step,
                                 last_accepted_));
  wanted_ = number;
}
} // namespace tamp::apps
