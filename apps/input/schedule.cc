// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/schedule.h>
#include <apps/input/stage_reader.h>

namespace tamp::apps
{
namespace
{
using fem::StageKind;
using fem::StageTarget;

double above_zero(StageReader &reader, const Dimension &dimension)
{
  const double value = reader.quantity(dimension);
  if (!(value > 0))
    reader.fail("a value > 0 before");
  return value;
}

double not_negative(StageReader &reader, const Dimension &dimension)
{
  const double value = reader.quantity(dimension);
  if (!(value >= 0))
    reader.fail("a value >= 0 before");
  return value;
}

void read_press(StageReader &reader,
                fem::Stage &stage,
                const ScheduleContext &context)
{
  const std::size_t first = reader.expect({"to", "upper", "lower", "both"});
  if (first > 0) {
    constexpr fem::Pressing who[] = {
        fem::Pressing::upper, fem::Pressing::lower, fem::Pressing::both};
    stage.pressing = who[first - 1];
    reader.expect({"to"});
  }
  switch (reader.expect({"density", "displacement", "force", "pressure"})) {
  case 0:
    stage.target = StageTarget::density;
    stage.value = above_zero(reader, dimension::number);
    break;
  case 1:
    stage.target = StageTarget::displacement;
    stage.value = above_zero(reader, dimension::length);
    break;
  case 2:
    stage.target = StageTarget::force;
    stage.value = above_zero(reader, dimension::force);
    break;
  default:
    stage.target = StageTarget::force;
    stage.value = above_zero(reader, dimension::pressure) * context.punch_area;
  }
}

double share_of_peak(StageReader &reader)
{
  const double share = reader.quantity(dimension::number);
  if (!(share >= 0 && share < 1))
    reader.fail("a share between 0 and 100 % before");
  reader.expect({"of"});
  reader.expect({"peak"});
  return share;
}

void read_unload(StageReader &reader,
                 fem::Stage &stage,
                 const ScheduleContext &context)
{
  if (reader.accept("by")) {
    stage.target = StageTarget::displacement;
    stage.value = above_zero(reader, dimension::length);
    return;
  }
  reader.expect({"to", "by"});
  if (reader.at_number()) {
    stage.target = StageTarget::peak_share;
    stage.value = share_of_peak(reader);
    return;
  }
  stage.target = StageTarget::force;
  // The last one is no word, but belongs into the complaint.
  switch (reader.expect({"force", "pressure", "nothing", "R % of peak"})) {
  case 0:
    stage.value = not_negative(reader, dimension::force);
    break;
  case 1:
    stage.value =
        not_negative(reader, dimension::pressure) * context.punch_area;
    break;
  default:
    stage.target = StageTarget::nothing;
    stage.value = 0;
  }
}

/// "holding R % of peak" or "freely", "by withdrawal", in any order.
void read_way_out(StageReader &reader, fem::Stage &stage)
{
  std::vector<std::string> words{"holding", "freely", "by"};
  while (!reader.done() && !words.empty()) {
    const std::string word = words[reader.expect(words)];
    std::erase(words, word);
    if (word == "by") {
      reader.expect({"withdrawal"});
      stage.ejection = fem::Ejection::withdrawal;
      continue;
    }
    stage.hold_share = word == "holding" ? share_of_peak(reader) : 0;
    std::erase(words, word == "holding" ? "freely" : "holding");
  }
}

void read_eject(StageReader &reader,
                fem::Stage &stage,
                const ScheduleContext &context)
{
  stage.value = 0;
  if (reader.expect({"to", "by"}) == 0) {
    constexpr StageTarget targets[] = {StageTarget::rim, StageTarget::out};
    stage.target = targets[reader.expect({"rim", "out"})];
  } else {
    stage.target = StageTarget::displacement;
    stage.value = above_zero(reader, dimension::length);
  }
  stage.hold_share = context.default_hold_share;
  read_way_out(reader, stage);
}
} // namespace

std::string name_of(fem::StageKind kind)
{
  switch (kind) {
  case StageKind::press:
    return "press";
  case StageKind::unload:
    return "unload";
  case StageKind::eject:
    return "eject";
  case StageKind::hold:
    return "hold";
  }
  return {};
}

std::vector<fem::Stage> parse_schedule(const std::string &stages,
                                       const ScheduleContext &context)
{
  constexpr StageKind kinds[] = {
      StageKind::press, StageKind::unload, StageKind::eject, StageKind::hold};
  std::vector<fem::Stage> schedule;
  for (const std::string &text : split_stages(stages)) {
    StageReader reader(text, static_cast<unsigned>(schedule.size() + 1));
    fem::Stage stage;
    stage.kind = kinds[reader.expect({"press", "unload", "eject", "hold"})];
    switch (stage.kind) {
    case StageKind::press:
      read_press(reader, stage, context);
      break;
    case StageKind::unload:
      read_unload(reader, stage, context);
      break;
    case StageKind::eject:
      read_eject(reader, stage, context);
      break;
    case StageKind::hold:
      stage.steps = reader.whole();
      reader.expect({"steps", "step"});
    }
    reader.finish();
    schedule.push_back(stage);
  }
  if (schedule.empty())
    throw InputError("there is no stage; expected for example 'press to "
                     "density 0.85; unload to 5 % of peak; eject to rim "
                     "holding 5 % of peak'");
  return schedule;
}
} // namespace tamp::apps
