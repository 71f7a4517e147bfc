// SPDX-License-Identifier: BSD-3-Clause
#include <dem/fire.h>

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
namespace
{
constexpr double largest_step = 1.4;
constexpr double growth = 1.1, shrink = 0.5, mixing_decay = 0.99;
constexpr unsigned patience = 5; // downhill moves before the step may grow
} // namespace

RelaxationMove Fire::next(const RelaxationSums &sums)
{
  RelaxationMove move{};
  double power = sums.power, kinetic = sums.kinetic, kept = 1;
  if (power > 0) {
    if (++downhill_ > patience) {
      step_ = std::min(step_ * growth, largest_step);
      mixing_ *= mixing_decay;
    }
  } else if (power < 0) {
    move.retreat = -0.5 * step_;
    power = kinetic = kept = 0; // all velocities are stopped
    step_ *= shrink;
    mixing_ = first_mixing;
    downhill_ = 0;
  }
  // Of the velocities after the kick v + step F / m.
  kinetic += step_ * (2 * power + step_ * sums.steepness);
  const double turn =
      sums.steepness > 0
          ? mixing_ * std::sqrt(std::max(0.0, kinetic) / sums.steepness)
          : 0.0;
  move.keep = (1 - mixing_) * kept;
  move.push = (1 - mixing_) * step_ + turn;
  move.step = step_;
  return move;
}
} // namespace tamp::dem
