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
// Looks between two reports to an observer.
constexpr std::size_t looks_between_reports = 1000;

/// What an observer is told of a motion whose cell is complete.
CellAnswer report_of(const Motion &motion, std::size_t steps_before)
{
  CellAnswer answer;
  answer.outcome = Outcome::unsettled;
  answer.stress = motion.stress();
  answer.unbalance = motion.unbalance();
  answer.evaluations = motion.steps() - steps_before;
  return answer;
}
} // namespace

CellAnswer servo_to_pressure(UnitCell &cell,
                             const ServoGoal &goal,
                             const Dynamics &settings,
                             const Arithmetic &arithmetic,
                             const CompressionObserver &observe)
{
  Positive{}(goal.pressure, "pressure of the servo");
  CellLaws(cell).check(cell);
  const double near = goal.accuracy * goal.pressure;
  ServoGain gain(settings.strain_rate);
  const auto motion = start_growing_motion(cell, settings, arithmetic);
  Outcome outcome = Outcome::unsettled;
  double step = 0, stiffness = 0, missing = goal.pressure;
  std::size_t reported = 0;
  for (std::size_t look = 0; motion->steps() < goal.most_steps; ++look) {
    if (look % looks_of_a_round == 0) {
      motion->write_cell();
      step = motion->time_step();
      stiffness = voigt_tangent(cell).topLeftCorner<3, 3>().sum() / 3;
    }
    if (observe && look > 0 && look % looks_between_reports == 0) {
      observe(cell, report_of(*motion, reported));
      reported = motion->steps();
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
  const CellAnswer answer = end_motion(*motion, outcome);
  if (observe && outcome != Outcome::diverged) {
    CellAnswer last = answer;
    last.evaluations -= reported;
    observe(cell, last);
  }
  return answer;
}
} // namespace tamp::dem
