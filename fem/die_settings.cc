// SPDX-License-Identifier: BSD-3-Clause
#include <fem/die_settings.h>
#include <fem/require.h>

#include <string>

namespace tamp::fem
{
namespace
{
bool target_fits(StageKind kind, StageTarget target)
{
  switch (kind) {
  case StageKind::press:
    return target == StageTarget::density ||
           target == StageTarget::displacement ||
           target == StageTarget::force || target == StageTarget::peak_share;
  case StageKind::unload:
    return target == StageTarget::displacement ||
           target == StageTarget::force || target == StageTarget::peak_share ||
           target == StageTarget::nothing;
  case StageKind::eject:
    return target == StageTarget::displacement || target == StageTarget::rim ||
           target == StageTarget::out;
  case StageKind::hold:
    return true;
  }
  return false;
}

void check_value(const Stage &stage, const std::string &name)
{
  if (stage.kind == StageKind::press && stage.target == StageTarget::density)
    require(stage.value > 0 && stage.value < 1,
            (name + "density").c_str(),
            stage.value,
            "between 0 and 1");
  else if (stage.kind == StageKind::press ||
           (stage.kind != StageKind::hold &&
            stage.target == StageTarget::displacement))
    require(stage.value > 0, (name + "value").c_str(), stage.value, "> 0");
  else
    require(stage.value >= 0, (name + "value").c_str(), stage.value, ">= 0");
}

void check_stage(const Stage &stage, const std::string &name)
{
  require(target_fits(stage.kind, stage.target),
          name + "target",
          static_cast<int>(stage.target),
          "one that fits the kind of stage: press to density, displacement, "
          "force or peak share; unload to displacement, force, peak share or "
          "nothing; eject to displacement, rim or out");
  check_value(stage, name);
  require(stage.hold_share >= 0 && stage.hold_share < 1,
          name + "hold share",
          stage.hold_share,
          "at least 0 and below 1");
  if (stage.kind == StageKind::hold)
    require(stage.steps > 0, (name + "steps").c_str(), stage.steps, "> 0");
}

/// How much closer the punches are after a stage at least [m].
double closing(const Stage &stage)
{
  if (stage.target != StageTarget::displacement)
    return 0;
  if (stage.kind == StageKind::unload)
    return -stage.value;
  if (stage.kind != StageKind::press)
    return 0;
  return stage.pressing == Pressing::both ? 2 * stage.value : stage.value;
}

/// What stages ask for together. The height is zero if it is not known.
void check_order(const std::vector<Stage> &stages, double height)
{
  bool pressed = false;
  double closed = 0;
  for (unsigned i = 0; i < stages.size(); ++i) {
    const std::string name = "stage " + std::to_string(i + 1);
    pressed = pressed || stages[i].kind == StageKind::press;
    if (stages[i].kind == StageKind::unload && !pressed)
      throw std::invalid_argument(
          name + " unloads what no stage has pressed; expected a stage that "
                 "presses before it");
    // How far a punch goes back to reach a force is not known.
    const bool unknown = stages[i].kind == StageKind::unload &&
                         stages[i].target != StageTarget::displacement;
    closed = unknown ? 0 : closed + closing(stages[i]);
    if (height > 0 && closed >= height) {
      std::ostringstream message;
      message << name << " brings the punches " << closed
              << " m closer than at the start, but the powder is only "
              << height << " m high: the upper punch would pass below the "
              << "lower one; expected less";
      throw std::invalid_argument(message.str());
    }
  }
}

void check_limits(const StepLimits &steps)
{
  require(steps.first > 0, "first step", steps.first, "> 0");
  require(steps.maximum > 0 && steps.maximum < 0.5,
          "maximum step",
          steps.maximum,
          "between 0 and 0.5");
  require(steps.unloading > 0 && steps.unloading < 0.5,
          "unloading step",
          steps.unloading,
          "between 0 and 0.5");
  require(steps.minimum > 0, "minimum step", steps.minimum, "> 0");
  require(steps.growth >= 1, "step growth", steps.growth, ">= 1");
  require(steps.cut > 0 && steps.cut < 1, "step cut", steps.cut, "in (0, 1)");
  require(steps.rim > 0 && steps.rim <= 1,
          "rim step",
          steps.rim,
          "above 0 and at most 1");
}

void check_solver(const SolverSettings &solver)
{
  require(solver.force_tolerance > 0,
          "force tolerance",
          solver.force_tolerance,
          "> 0");
  require(solver.least_reaction > 0 && solver.least_reaction <= 1,
          "force floor",
          solver.least_reaction,
          "above 0 and at most 1");
  require(solver.displacement_tolerance > 0,
          "displacement tolerance",
          solver.displacement_tolerance,
          "> 0");
  require(solver.maximum_iterations > 0,
          "maximum iterations",
          solver.maximum_iterations,
          "> 0");
}
} // namespace

bool Stage::frees() const
{
  if (kind == StageKind::eject)
    return hold_share <= 0;
  return kind == StageKind::unload &&
         (target == StageTarget::nothing ||
          (value <= 0 && target != StageTarget::displacement));
}

void DieSettings::check() const
{
  geometry.check();
  for (const FrictionCoefficient &coefficient : friction)
    require(coefficient.table.smallest() >= 0,
            "friction coefficient",
            coefficient.table.smallest(),
            ">= 0");
  const double wall = friction[die_wall].table.largest();
  if (floating_die)
    require(wall > 0,
            "wall friction coefficient",
            wall,
            "> 0: nothing else carries a floating die");
  check_limits(steps);
  check_solver(solver);
  for (unsigned i = 0; i < stages.size(); ++i)
    check_stage(stages[i], "stage " + std::to_string(i + 1) + ": ");
  check_way(geometry.mesh_file.empty() ? geometry.fill_height : 0);
}

void DieSettings::check_way(double height) const
{
  check_order(stages, height);
}

void DieSettings::check_start(double density) const
{
  for (unsigned i = 0; i < stages.size(); ++i) {
    const Stage &stage = stages[i];
    if (stage.kind != StageKind::press)
      continue;
    if (stage.target != StageTarget::density || density < stage.value)
      return;
    std::ostringstream expected;
    expected << "more than the powder has at the start, " << density;
    require(false,
            ("stage " + std::to_string(i + 1) + ": density").c_str(),
            stage.value,
            expected.str().c_str());
  }
}
} // namespace tamp::fem
