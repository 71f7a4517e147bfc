// SPDX-License-Identifier: BSD-3-Clause
#include <dem/dynamics.h>
#include <dem/measures.h>
#include <dem/servo.h>
#include <dem/unit_cell.h>
#include <dem/value_check.h>

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
namespace
{
double mean_pressure(const Matrix3 &stress)
{
  return -stress.trace() / 3;
}

// Time steps between two looks at the pressure.
constexpr double steps_between_looks = 20;
// Slower than this share of the first rate the servo does not go: the cell is
// at rest then, and must still move for the grains to come to rest, too.
constexpr double slowest_share = 1e-6;
} // namespace

CellAnswer servo_to_pressure(UnitCell &cell,
                             const ServoGoal &goal,
                             const Dynamics &settings)
{
  Positive{}(goal.pressure, "pressure of the servo");
  const double time = steps_between_looks * settings.time_step_fraction *
                      rayleigh_time_step(cell.materials[0],
                                         cell.smallest_radius(),
                                         settings.density_scaling);
  CellAnswer answer;
  answer.stress = love_weber_stress(cell);
  double missing = goal.pressure - mean_pressure(answer.stress);
  double gain = missing != 0 ? settings.strain_rate / std::abs(missing) : 0;
  std::size_t spent = 0;
  do {
    const double rate =
        std::copysign(std::clamp(gain * std::abs(missing),
                                 slowest_share * settings.strain_rate,
                                 settings.strain_rate),
                      missing);
    Dynamics now = settings;
    now.strain_rate = std::abs(rate);
    answer = deform_by_dynamics(
        cell, std::exp(-rate * time) * Stretch::Identity(), now);
    spent += answer.evaluations;
    answer.evaluations = spent;
    if (answer.outcome == Outcome::diverged)
      return answer;
    const double before = missing;
    missing = goal.pressure - mean_pressure(answer.stress);
    if (missing * before < 0)
      gain *= 0.5;
    if (std::abs(missing) <= goal.accuracy * goal.pressure &&
        answer.unbalance <= goal.unbalance) {
      answer.outcome = Outcome::settled;
      return answer;
    }
  } while (spent < goal.most_steps);
  answer.outcome = Outcome::unsettled;
  return answer;
}
} // namespace tamp::dem
