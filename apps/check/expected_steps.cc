// SPDX-License-Identifier: BSD-3-Clause
#include <apps/check/expected_steps.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
using fem::Stage;
using fem::StageKind;
using fem::StageTarget;

// Steps of an unloading, or of a way to a force that is not known.
constexpr double guess = 30;
// A compact that slides as a whole goes so much further, see StepLimits.
constexpr double sliding = 20;
constexpr double nearly_solid = 0.97;

// Steps that grow from `first` to `most` and add up to `strain`.
double steps_over(double strain, double most, const fem::StepLimits &limits)
{
  const double first = std::min(limits.first, most);
  const double growth = limits.growth;
  if (growth <= 1)
    return std::ceil(strain / first);
  const double growing = std::log(most / first) / std::log(growth);
  const double covered = (most - first) / (growth - 1);
  if (strain < covered)
    return std::ceil(std::log1p(strain * (growth - 1) / first) /
                     std::log(growth));
  return std::ceil(growing + (strain - covered) / most);
}

std::string target_of(const Stage &stage)
{
  switch (stage.target) {
  case StageTarget::density:
    return fmt::format("to a mean relative density of {:.4g}", stage.value);
  case StageTarget::displacement:
    return fmt::format("by {:.4g} mm", 1e3 * stage.value);
  case StageTarget::force:
    return fmt::format("to {:.4g} kN", stage.value / 1e3);
  case StageTarget::peak_share:
    return fmt::format("to {:.4g} % of the peak", 100 * stage.value);
  case StageTarget::nothing:
    return "until the punch has left the compact";
  case StageTarget::rim:
    return "until the upper face is at the rim";
  case StageTarget::out:
    return "until the compact has left the die";
  }
  return {};
}

std::string text_of(const Stage &stage)
{
  switch (stage.kind) {
  case StageKind::press:
    return fmt::format(
        "press {} {}",
        stage.pressing == fem::Pressing::both    ? "with both punches"
        : stage.pressing == fem::Pressing::lower ? "with the lower punch"
                                                 : "with the upper punch",
        target_of(stage));
  case StageKind::unload:
    return "unload " + target_of(stage);
  case StageKind::eject:
    return fmt::format(
        "eject {}, {}{}",
        target_of(stage),
        stage.hold_share > 0 ? fmt::format("holding {:.4g} % of the peak",
                                           100 * stage.hold_share)
                             : "freely",
        stage.ejection == fem::Ejection::withdrawal ? ", the die is drawn down"
                                                    : "");
  case StageKind::hold:
    return "hold";
  }
  return {};
}

// Follows the powder's density through the stages.
class Forecast
{
public:
  Forecast(const fem::DieSettings &die,
           const FilledDie &filled,
           const MaterialTrial &trial)
      : die_(die), filled_(filled), trial_(trial),
        start_(trial.states.front().relative_density), density_(start_)
  {
  }

  ExpectedStage next(const Stage &stage)
  {
    ExpectedStage expected{text_of(stage), guess, 0, {}};
    switch (stage.kind) {
    case StageKind::press:
      press(stage, expected);
      break;
    case StageKind::unload:
      if (stage.target == StageTarget::displacement)
        expected.steps = steps_over(
            stage.value / height(), die_.steps.unloading, die_.steps);
      break;
    case StageKind::eject:
      expected.steps = eject(stage);
      break;
    case StageKind::hold:
      expected.steps = stage.steps;
    }
    expected.relative_density = density_;
    return expected;
  }

private:
  // Of the compact [m].
  double height() const { return filled_.height * start_ / density_; }

  void press(const Stage &stage, ExpectedStage &expected)
  {
    const double before = density_;
    if (stage.target == StageTarget::density)
      density_ = stage.value;
    else if (stage.target == StageTarget::displacement) {
      const double movers = stage.pressing == fem::Pressing::both ? 2 : 1;
      const double left = height() - movers * stage.value;
      density_ = left > 0 ? start_ * filled_.height / left : 1;
      if (density_ > 1)
        expected.doubt = fmt::format(
            "the punches then leave {:.4g} mm for powder that is solid at "
            "{:.4g} mm, unless it goes elsewhere; expected less",
            1e3 * left,
            1e3 * filled_.height * start_);
    } else if (stage.target == StageTarget::force)
      press_to(stage.value / filled_.punch_area, expected);
    density_ = std::min(density_, 1.);
    if (density_ > before)
      expected.steps = steps_over(
          std::log(density_ / before), die_.steps.maximum, die_.steps);
  }

  void press_to(double pressure, ExpectedStage &expected)
  {
    expected.text += fmt::format(" ({:.4g} MPa)", pressure / 1e6);
    if (const auto met = trial_.density_at(pressure)) {
      density_ = std::max(density_, *met);
      return;
    }
    const MaterialTrial::State &last = trial_.states.back();
    if (last.relative_density > nearly_solid)
      expected.doubt = fmt::format(
          "{:.4g} MPa may never be reached: between smooth walls the powder "
          "bears {:.4g} MPa at a relative density of {:.3g}; expected less",
          pressure / 1e6,
          last.axial_pressure / 1e6,
          last.relative_density);
    density_ = std::max(density_, last.relative_density);
  }

  double eject(const Stage &stage) const
  {
    const double gone = stage.target == StageTarget::displacement
                            ? stage.value
                            : std::max(filled_.height - height(), 0.);
    double steps =
        steps_over(gone / height(), sliding * die_.steps.unloading, die_.steps);
    if (stage.target == StageTarget::out)
      steps += die_.geometry.axial_elements / die_.steps.rim;
    return steps + (stage.frees() ? guess : 0);
  }

  const fem::DieSettings &die_;
  FilledDie filled_;
  const MaterialTrial &trial_;
  double start_, density_;
};
} // namespace

std::vector<ExpectedStage> expected_stages(const fem::DieSettings &die,
                                           const FilledDie &filled,
                                           const MaterialTrial &trial)
{
  std::vector<ExpectedStage> stages;
  Forecast forecast(die, filled, trial);
  for (const Stage &stage : die.stages)
    stages.push_back(forecast.next(stage));
  return stages;
}

std::vector<ExpectedStage> expected_stages(const ProbePath &path)
{
  using Control = fem::ComponentTarget::Control;
  std::vector<ExpectedStage> stages;
  std::array<double, 6> strain{};
  for (const ProbeStage &probe : path.stages) {
    const fem::PathStage &stage = probe.stage;
    double largest = 0;
    bool known = !stage.has_until && probe.peak_share <= 0;
    for (unsigned k = 0; k < 6; ++k) {
      const fem::ComponentTarget &target = stage.components[k];
      if (target.control == Control::stress)
        continue;
      const double change =
          target.relative ? target.value : target.value - strain[k];
      largest = std::max(largest, std::abs(change));
      if (known)
        strain[k] += change;
    }
    double steps = known && largest > 0
                       ? std::ceil(largest / stage.maximum_increment)
                       : stage.minimum_steps;
    if (!known || (largest <= 0 && stage.minimum_steps <= 1))
      steps = guess;
    if (!stage.gradients.empty())
      steps = double(stage.gradients.size());
    stages.push_back(
        {stage.name, std::max<double>(steps, stage.minimum_steps), 0, {}});
  }
  if (!path.increments.empty() && !stages.empty())
    stages.front().steps = double(path.increments.size());
  return stages;
}

double sum_of_steps(const std::vector<ExpectedStage> &stages)
{
  double sum = 0;
  for (const ExpectedStage &stage : stages)
    sum += stage.steps;
  return sum;
}
} // namespace tamp::apps
