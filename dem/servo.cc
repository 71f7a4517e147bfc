// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/growing_motion.h>
#include <dem/servo.h>
#include <dem/servo_gain.h>
#include <dem/tangent.h>
#include <dem/unit_cell.h>
#include <dem/value_check.h>

#include <cmath>

namespace tamp::dem
{
namespace
{
// Time steps between two looks at the pressure, and looks after which stiffness
// and time step are taken anew.
constexpr std::size_t steps_between_looks = 5, looks_of_a_round = 100;
} // namespace

CellAnswer servo_to_pressure(UnitCell &cell,
                             const ServoGoal &goal,
                             const Dynamics &settings,
                             const Arithmetic &arithmetic)
{
  Positive{}(goal.pressure, "pressure of the servo");
  CellLaws(cell).check(cell);
  const double near = goal.accuracy * goal.pressure;
  ServoGain gain(settings.strain_rate);
  const auto motion = start_growing_motion(cell, settings, arithmetic);
  Outcome outcome = Outcome::unsettled;
  double step = 0, stiffness = 0, missing = goal.pressure;
  for (std::size_t look = 0; motion->steps() < goal.most_steps; ++look) {
    if (look % looks_of_a_round == 0) {
      motion->write_cell();
      step = motion->time_step();
      stiffness = voigt_tangent(cell).topLeftCorner<3, 3>().sum() / 3;
    }
    missing = goal.pressure + motion->stress().trace() / 3;
    const double time = step * double(steps_between_looks);
    const double rate = -gain.rate(missing, near, stiffness, time);
    if (!motion->advance(
            rate * time * Matrix3::Identity(), steps_between_looks, step)) {
      outcome = Outcome::diverged;
      break;
    }
    missing = goal.pressure + motion->stress().trace() / 3;
    if (std::abs(missing) <= near && motion->unbalance() <= goal.unbalance) {
      outcome = Outcome::settled;
      break;
    }
  }
  return end_motion(*motion, outcome);
}
} // namespace tamp::dem
