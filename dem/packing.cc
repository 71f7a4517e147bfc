// SPDX-License-Identifier: BSD-3-Clause
#include <dem/deform.h>
#include <dem/measures.h>
#include <dem/packing.h>
#include <dem/random_start.h>
#include <dem/unit_cell.h>
#include <dem/value_check.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tamp::dem
{
namespace
{
double mean_pressure(const CellAnswer &answer)
{
  return -answer.stress.trace() / 3;
}

/// Isotropic compression in steps of the quasi-static map. Steps are long while
/// grains are loose and are shortened, from the state before, where they would
/// overshoot the pressure.
class IsotropicCompression
{
public:
  IsotropicCompression(UnitCell &cell, double wanted)
      : cell_(cell), wanted_(wanted)
  {
  }

  void run()
  {
    for (int k = 0; k < most_steps; ++k)
      if (advance())
        return;
    throw std::runtime_error("the packing did not reach a pressure of " +
                             std::to_string(wanted_) + " Pa; it stands at " +
                             std::to_string(pressure_) +
                             " Pa with a relative density of " +
                             std::to_string(cell_.relative_density()));
  }

private:
  static constexpr int most_steps = 5000;
  static constexpr double longest_step = 2e-3, shortest_step = 1e-7;
  static constexpr double accuracy = 0.01;

  /// One step; true if the pressure is reached at equilibrium.
  bool advance()
  {
    Driving driving;
    // A loose packing needs no equilibrium, only a way into a denser one. With
    // much less than this, pushing it ahead makes it denser than slow dynamics
    // would.
    const bool loose = pressure_ < 0.1 * wanted_;
    driving.quasi_static.maximum_evaluations = loose ? 1000 : 3000;
    // What is left of the forces of a first few contacts does not matter at
    // the wanted pressure, where contacts carry about p d^2.
    const double diameter = 2 * cell_.mean_radius();
    driving.quasi_static.force_floor = 0.1 * wanted_ * diameter * diameter;
    const UnitCell before = cell_;
    const CellAnswer answer =
        deform(cell_, std::exp(-step_) * Stretch::Identity(), driving);
    const double now = mean_pressure(answer);
    if (answer.outcome == Outcome::diverged || now > (1 + accuracy) * wanted_)
      return step_back(before, now);
    const double gained = now - pressure_;
    pressure_ = now;
    if (answer.outcome == Outcome::settled && now > (1 - accuracy) * wanted_)
      return true;
    if (gained > 0)
      step_ *= std::clamp((wanted_ - now) / gained, 0.1, 1.5);
    step_ = std::clamp(step_, shortest_step, longest_step);
    return false;
  }

  bool step_back(const UnitCell &before, double now)
  {
    cell_ = before;
    const double share = (wanted_ - pressure_) / (now - pressure_);
    step_ *= std::isfinite(share) ? std::clamp(share, 0.1, 0.7) : 0.3;
    step_ = std::max(step_, shortest_step);
    return false;
  }

  UnitCell &cell_;
  double wanted_;
  double pressure_ = 0, step_ = longest_step;
};
} // namespace

void PackingRequest::check() const
{
  sizes.check();
  material.check();
  contact.check();
  if (grain_count < 20)
    refuse("grain count", double(grain_count), "at least 20");
  Positive{}(pressure, "packing pressure");
  if (!(initial_relative_density > 0 && initial_relative_density <= 0.38))
    refuse("initial relative density",
           initial_relative_density,
           "above 0 and at most 0.38");
}

UnitCell make_packing(const PackingRequest &request)
{
  request.check();
  UnitCell cell = random_start(request);
  if (request.friction_during_packing >= 0)
    cell.contact.friction_coefficient = request.friction_during_packing;
  IsotropicCompression(cell, request.pressure).run();
  if (cell.contact != request.contact) {
    // Contacts that the friction of the run cannot hold slip now.
    cell.contact = request.contact;
    deform(cell, Stretch::Identity(), {});
  }
  cell.reference_volume = cell.box.volume();
  cell.last = {};
  cell.energy = {};
  return cell;
}
} // namespace tamp::dem
