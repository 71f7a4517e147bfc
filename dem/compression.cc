// SPDX-License-Identifier: BSD-3-Clause
#include <dem/compression.h>
#include <dem/deform.h>
#include <dem/measures.h>
#include <dem/unit_cell.h>
#include <dem/value_check.h>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <stdexcept>
#include <string>

namespace tamp::dem
{
namespace
{
double softest_modulus(const UnitCell &cell)
{
  return std::ranges::min(
      cell.materials | std::views::transform(&GrainMaterial::youngs_modulus));
}

/// Steps of the quasi-static map. They are long while grains are loose and are
/// shortened, from the state before, where they would overshoot the goal.
class Steps
{
public:
  Steps(UnitCell &cell,
        const CompressionGoal &goal,
        const CompressionObserver &observe)
      : cell_(cell), goal_(goal), observe_(observe),
        to_density_(goal.target == CompressionTarget::relative_density),
        pressure_(goal_pressure(goal.compression, love_weber_stress(cell))),
        scale_(to_density_ ? light_pressure * softest_modulus(cell)
                           : goal.pressure)
  {
  }

  void run()
  {
    for (int k = 0; k < most_steps; ++k)
      if (to_density_ ? advance_to_density() : advance_to_pressure())
        return;
    throw std::runtime_error(
        "the packing did not reach " +
        (to_density_
             ? "equilibrium at a relative density of " +
                   std::to_string(goal_.relative_density)
             : "a pressure of " + std::to_string(goal_.pressure) + " Pa") +
        "; it stands at " + std::to_string(pressure_) +
        " Pa with a relative density of " +
        std::to_string(cell_.relative_density()));
  }

private:
  static constexpr int most_steps = 5000, most_rests = 20;
  static constexpr double longest_step = 2e-3, shortest_step = 1e-7;
  // Of the overlap at the goal over the diameter, (p / E)^(2/3): as much as one
  // careful step may push grains into each other. Longer ones put more energy
  // into contacts than the packing will hold, which shakes it denser than slow
  // dynamics would, and loses the loosest packings.
  static constexpr double careful_share = 0.8, shortest_careful_step = 5e-5;
  // Evaluations that tell of a packing which begins to carry.
  static constexpr std::size_t busy = 250;
  static constexpr double accuracy = 0.01;
  // Of Young's modulus: a pressure at which hard grains just jam.
  static constexpr double light_pressure = 1e-6;

  /// One step; true if the pressure is reached at equilibrium.
  bool advance_to_pressure()
  {
    const double wanted = goal_.pressure;
    const UnitCell before = cell_;
    const CellAnswer answer = stretch(step_);
    const double now = goal_pressure(goal_.compression, answer.stress);
    if (answer.outcome == Outcome::diverged || now > (1 + accuracy) * wanted)
      return step_back(before, now);
    const double gained = now - pressure_;
    accept(answer);
    if (answer.evaluations > busy)
      most_ = careful_step();
    if (answer.outcome == Outcome::settled && now > (1 - accuracy) * wanted)
      return true;
    if (gained > 0)
      step_ *= std::clamp((wanted - now) / gained, 0.1, 1.5);
    step_ = std::clamp(step_, shortest_step, most_);
    return false;
  }

  double careful_step() const
  {
    const double overlap =
        std::cbrt(std::pow(goal_.pressure / softest_modulus(cell_), 2));
    return std::clamp(
        careful_share * overlap, shortest_careful_step, longest_step);
  }

  bool step_back(const UnitCell &before, double now)
  {
    cell_ = before;
    const double share = (goal_.pressure - pressure_) / (now - pressure_);
    step_ *= std::isfinite(share) ? std::clamp(share, 0.1, 0.7) : 0.3;
    step_ = std::max(step_, shortest_step);
    return false;
  }

  /// One step; true if the density is reached at equilibrium.
  bool advance_to_density()
  {
    const double left =
        std::log(goal_.relative_density / cell_.relative_density()) /
        directions();
    // The last step may be a little longer, rather than leave a crumb.
    const bool last = left < 1.01 * step_;
    const UnitCell before = cell_;
    const CellAnswer answer = stretch(last ? left : step_);
    if (answer.outcome == Outcome::diverged) {
      cell_ = before;
      step_ = std::max(0.3 * step_, shortest_step);
      return false;
    }
    accept(answer);
    if (!last)
      return false;
    step_ = shortest_step; // at the goal only rest is left
    if (answer.outcome != Outcome::settled && ++rests_ > most_rests)
      throw std::runtime_error(
          "the packing did not settle at a relative density of " +
          std::to_string(goal_.relative_density) + "; its unbalance is " +
          std::to_string(answer.unbalance));
    return answer.outcome == Outcome::settled;
  }

  /// Logarithmic strain of the box, compression positive, in each direction
  /// that shrinks.
  CellAnswer stretch(double strain)
  {
    Driving driving;
    // A loose packing needs no equilibrium, only a way into a denser one. With
    // much less than this, pushing it ahead makes it denser than slow dynamics
    // would.
    const bool loose = pressure_ < 0.1 * scale_;
    driving.quasi_static.maximum_evaluations = loose ? 1000 : 3000;
    // What is left of the forces of a first few contacts does not matter at
    // the wanted pressure, where contacts carry about p d^2.
    const double diameter = 2 * cell_.mean_radius();
    driving.quasi_static.force_floor = 0.1 * scale_ * diameter * diameter;
    const double shrunk = std::exp(-strain);
    Stretch stretch = shrunk * Stretch::Identity();
    if (goal_.compression == Compression::uniaxial)
      stretch(0, 0) = stretch(1, 1) = 1;
    return deform(cell_, stretch, driving);
  }

  double directions() const
  {
    return goal_.compression == Compression::uniaxial ? 1 : 3;
  }

  void accept(const CellAnswer &answer)
  {
    pressure_ = goal_pressure(goal_.compression, answer.stress);
    if (observe_)
      observe_(cell_, answer);
  }

  UnitCell &cell_;
  const CompressionGoal &goal_;
  const CompressionObserver &observe_;
  bool to_density_;
  double pressure_; // now [Pa]
  double scale_;    // of the pressures that matter [Pa]
  double step_ = longest_step, most_ = longest_step;
  int rests_ = 0;
};
} // namespace

void CompressionGoal::check() const
{
  if (target == CompressionTarget::pressure)
    Positive{}(pressure, "packing pressure");
  else if (!(relative_density > 0 && relative_density < 1))
    refuse(
        "relative density of the packing", relative_density, "between 0 and 1");
}

void compress(UnitCell &cell,
              const CompressionGoal &goal,
              const CompressionObserver &observe)
{
  goal.check();
  if (goal.target == CompressionTarget::relative_density &&
      cell.relative_density() > goal.relative_density * (1 + 1e-12))
    throw std::runtime_error("the packing is denser, " +
                             std::to_string(cell.relative_density()) +
                             ", than the relative density wanted, " +
                             std::to_string(goal.relative_density));
  if (const double now =
          goal_pressure(goal.compression, love_weber_stress(cell));
      goal.target == CompressionTarget::pressure && now > 1.01 * goal.pressure)
    throw std::runtime_error("the packing is under " + std::to_string(now) +
                             " Pa already, more than the " +
                             std::to_string(goal.pressure) + " Pa wanted");
  Steps(cell, goal, observe).run();
}

double goal_pressure(Compression compression, const Matrix3 &stress)
{
  return compression == Compression::uniaxial ? -stress(2, 2)
                                              : -stress.trace() / 3;
}
} // namespace tamp::dem
