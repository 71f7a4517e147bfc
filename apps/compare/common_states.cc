// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/common_states.h>
#include <apps/compare/compared_curves.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace tamp::apps
{
namespace
{
struct WrittenLine {
  std::size_t line = 0;
  WrittenFields fields;
};

// The states that a run has written in one of its stages.
std::vector<WrittenLine> written_in(const ResultFolder &run, std::size_t stage)
{
  const auto &steps = run.curve.column("step");
  const StageLines &lines = run.curve.stages()[stage];
  std::vector<WrittenLine> written;
  for (std::size_t i = lines.first + (stage > 0 ? 1 : 0); i <= lines.last; ++i)
    for (const WrittenFields &fields : run.fields)
      if (fields.step == steps[i]) {
        written.push_back({i, fields});
        break;
      }
  return written;
}

bool has_ended(const ResultFolder &run, std::size_t stage)
{
  return stage + 1 < run.curve.stages().size() || run.finished();
}

// How far the tools have come in a stage [m].
double travel_in(const ResultFolder &run, std::size_t stage, std::size_t line)
{
  const StageLines &lines = run.curve.stages()[stage];
  const bool ejects = run.curve.kind(lines.stage) == "eject";
  const auto &way = run.curve.column(ejects ? "travel[m]" : "approach[m]");
  return std::abs(way[line] - way[lines.first]);
}

std::string words_of(const ResultFolder &run, std::size_t stage, bool ended)
{
  const unsigned number = run.curve.stages()[stage].stage;
  const std::string kind = run.curve.kind(number);
  return fmt::format("{} stage {}{}",
                     ended ? "end of" : "last state that all have written in",
                     number,
                     kind.empty() ? "" : " (" + kind + ")");
}

// The state of all runs at the end of a stage, or as far as all have come.
std::optional<CommonState> state_in(std::span<const ResultFolder> runs,
                                    std::size_t stage)
{
  std::vector<std::vector<WrittenLine>> written;
  bool ended = true;
  double least = std::numeric_limits<double>::max();
  for (const ResultFolder &run : runs) {
    written.push_back(written_in(run, stage));
    if (written.back().empty())
      return {};
    const std::size_t last = written.back().back().line;
    ended = ended && has_ended(run, stage) &&
            last == run.curve.stages()[stage].last;
    least = std::min(least, travel_in(run, stage, last));
  }
  CommonState state{"", words_of(runs.front(), stage, ended), {}, {}};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto distance = [&](const WrittenLine &at) {
      return std::abs(travel_in(runs[i], stage, at.line) - least);
    };
    const WrittenLine &found =
        ended ? written[i].back()
              : *std::ranges::min_element(written[i], {}, distance);
    state.of_run.push_back(found.fields);
    state.lines.push_back(found.line);
  }
  return state;
}

// The stage with the largest force of a punch, of those that press.
std::size_t pressing_stage(const ResultCurve &curve)
{
  const auto &upper = curve.column("upper_force[N]");
  const auto &lower = curve.column("lower_force[N]");
  std::size_t found = 0;
  double peak = 0;
  for (std::size_t stage = 0; stage < curve.stages().size(); ++stage) {
    const StageLines &lines = curve.stages()[stage];
    if (curve.kind(lines.stage) != "press")
      continue;
    for (std::size_t i = lines.first; i <= lines.last; ++i)
      if (const double force = std::max(upper[i], lower[i]); force > peak) {
        peak = force;
        found = stage;
      }
  }
  return found;
}
} // namespace

std::vector<CommonState> common_states(std::span<const ResultFolder> runs)
{
  const std::size_t stages = common_stages(runs);
  if (stages == 0)
    return {};
  const auto search = [&](std::size_t last) {
    std::optional<CommonState> state;
    for (std::size_t stage = last + 1; stage-- > 0 && !state;)
      state = state_in(runs, stage);
    return state;
  };
  auto pressed =
      search(std::min(pressing_stage(runs.front().curve), stages - 1));
  auto end = search(stages - 1);
  std::vector<CommonState> states;
  if (pressed) {
    pressed->name = "pressed";
    states.push_back(*pressed);
  }
  if (end && (!pressed || end->lines != pressed->lines)) {
    end->name = "end";
    states.push_back(*end);
  }
  return states;
}
} // namespace tamp::apps
