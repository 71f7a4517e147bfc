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
    return target != StageTarget::rim;
  case StageKind::unload:
    return target == StageTarget::displacement ||
           target == StageTarget::force || target == StageTarget::peak_share;
  case StageKind::eject:
    return target == StageTarget::displacement || target == StageTarget::rim;
  case StageKind::hold:
    return true;
  }
  return false;
}

void check_stage(const Stage &stage, unsigned number)
{
  const std::string name = "stage " + std::to_string(number) + ": ";
  require(target_fits(stage.kind, stage.target),
          name + "target",
          static_cast<int>(stage.target),
          "one that fits the kind of stage: press to density, displacement, "
          "force or peak share; unload to displacement, force or peak share; "
          "eject to displacement or rim");
  require(stage.value >= 0, name + "value", stage.value, ">= 0");
  if (stage.kind == StageKind::press && stage.target == StageTarget::density)
    require(stage.value > 0, name + "density", stage.value, "> 0");
  require(stage.hold_share >= 0 && stage.hold_share < 1,
          name + "hold share",
          stage.hold_share,
          "at least 0 and below 1");
}
} // namespace

void DieSettings::check() const
{
  geometry.check();
  require(wall_friction_coefficient >= 0,
          "wall friction coefficient",
          wall_friction_coefficient,
          ">= 0");
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
  require(solver.force_tolerance > 0,
          "force tolerance",
          solver.force_tolerance,
          "> 0");
  require(solver.displacement_tolerance > 0,
          "displacement tolerance",
          solver.displacement_tolerance,
          "> 0");
  require(solver.maximum_iterations > 0,
          "maximum iterations",
          solver.maximum_iterations,
          "> 0");
  for (unsigned i = 0; i < stages.size(); ++i)
    check_stage(stages[i], i + 1);
}
} // namespace tamp::fem
