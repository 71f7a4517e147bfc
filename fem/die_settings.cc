// SPDX-License-Identifier: BSD-3-Clause
#include <fem/die_settings.h>

#include <sstream>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
template <class Value>
void require(bool possible,
             const char *name,
             const Value &value,
             const char *expected)
{
  if (possible)
    return;
  std::ostringstream message;
  message << name << " is " << value << "; expected " << expected;
  throw std::invalid_argument(message.str());
}

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
          (name + "target").c_str(),
          static_cast<int>(stage.target),
          "one that fits the kind of stage: press to density, displacement, "
          "force or peak share; unload to displacement, force or peak share; "
          "eject to displacement or rim");
  require(stage.value >= 0, (name + "value").c_str(), stage.value, ">= 0");
  if (stage.kind == StageKind::press && stage.target == StageTarget::density)
    require(stage.value > 0, (name + "density").c_str(), stage.value, "> 0");
  require(stage.hold_share >= 0 && stage.hold_share < 1,
          (name + "hold share").c_str(),
          stage.hold_share,
          "at least 0 and below 1");
}
} // namespace

void DieGeometry::check() const
{
  if (!mesh_file.empty())
    return;
  require(radius > 0, "radius", radius, "> 0 m");
  require(fill_height > 0, "fill height", fill_height, "> 0 m");
  require(radial_elements > 0, "radial elements", radial_elements, "> 0");
  require(axial_elements > 0, "axial elements", axial_elements, "> 0");
}

void DieSettings::check() const
{
  geometry.check();
  for (const FrictionCoefficient &coefficient : friction)
    require(coefficient.table.smallest() >= 0,
            "friction coefficient",
            coefficient.table.smallest(),
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
