// SPDX-License-Identifier: BSD-3-Clause
#include <dem/fire.h>

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
namespace
{
constexpr double first_step = 0.7, largest_step = 1.4;
constexpr double growth = 1.1, shrink = 0.5;
constexpr double first_mixing = 0.1, mixing_decay = 0.99;
constexpr unsigned patience = 5; // downhill moves before the step may grow
} // namespace

Fire::Fire(std::vector<double> mass)
    : mass_(std::move(mass)), velocity_(mass_.size(), 0.0), step_(first_step),
      mixing_(first_mixing)
{
}

void Fire::move(std::span<double> position, std::span<const double> force)
{
  double power = 0;
  for (std::size_t k = 0; k < mass_.size(); ++k)
    power += force[k] * velocity_[k];
  if (power > 0) {
    if (++downhill_ > patience) {
      step_ = std::min(step_ * growth, largest_step);
      mixing_ *= mixing_decay;
    }
  } else if (power < 0) {
    for (std::size_t k = 0; k < mass_.size(); ++k)
      position[k] -= 0.5 * step_ * velocity_[k];
    std::ranges::fill(velocity_, 0.0);
    step_ *= shrink;
    mixing_ = first_mixing;
    downhill_ = 0;
  }

  double kinetic = 0, steepness = 0;
  for (std::size_t k = 0; k < mass_.size(); ++k) {
    velocity_[k] += step_ * force[k] / mass_[k];
    kinetic += mass_[k] * velocity_[k] * velocity_[k];
    steepness += force[k] * force[k] / mass_[k];
  }
  const double turn =
      steepness > 0 ? mixing_ * std::sqrt(kinetic / steepness) : 0.0;
  for (std::size_t k = 0; k < mass_.size(); ++k) {
    velocity_[k] = (1 - mixing_) * velocity_[k] + turn * force[k] / mass_[k];
    position[k] += step_ * velocity_[k];
  }
}
} // namespace tamp::dem
