// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/cell_shape.h>
#include <dem/deform.h>
#include <dem/packing.h>
#include <dem/random_start.h>
#include <dem/servo.h>
#include <dem/unit_cell.h>
#include <dem/value_check.h>

#include <stdexcept>

namespace tamp::dem
{
namespace
{
constexpr std::size_t most_others = 254; // a species is a byte

/// Packs by damped motion under a servo; grains are at rest then.
void pack_by_dynamics(UnitCell &cell,
                      const PackingRequest &request,
                      const CompressionObserver &observe)
{
  ServoGoal goal;
  goal.pressure = request.goal.pressure;
  goal.most_steps = 20000000; // minutes
  const CellAnswer answer =
      servo_to_pressure(cell, goal, *request.dynamics, {}, observe);
  if (answer.outcome != Outcome::settled)
    throw std::runtime_error(
        "the packing did not come to rest by dynamics at a pressure of " +
        std::to_string(goal.pressure) + " Pa; it stands at " +
        std::to_string(goal_pressure(Compression::isotropic, answer.stress)) +
        " Pa with a relative density of " +
        std::to_string(cell.relative_density()));
  cell.velocity.clear();
  cell.spin.clear();
}
} // namespace

void PackingRequest::check() const
{
  sizes.check();
  material.check();
  contact.check();
  if (contact.normal_law == NormalLaw::mdr && !others.empty())
    throw std::invalid_argument(
        "normal law mdr: its contacts are of two grains of one material, and "
        "the packing has further kinds of grains; expected one kind");
  if (others.size() > most_others)
    refuse("further kinds of grains", double(others.size()), "at most 254");
  double shares = 0;
  for (const GrainPopulation &other : others) {
    other.sizes.check();
    other.material.check();
    if (!(other.number_share > 0 && other.number_share < 1))
      refuse("number share", other.number_share, "between 0 and 1");
    shares += other.number_share;
  }
  if (shares >= 1)
    refuse("sum of the number shares of further grains", shares, "below 1");
  if (grain_count < 20)
    refuse("grain count", double(grain_count), "at least 20");
  if (!(initial_relative_density > 0 && initial_relative_density <= 0.38))
    refuse("initial relative density",
           initial_relative_density,
           "above 0 and at most 0.38");
  goal.check();
  if (goal.target == CompressionTarget::relative_density &&
      goal.relative_density < initial_relative_density)
    refuse("relative density of the packing",
           goal.relative_density,
           "at least the initial relative density");
  if (dynamics && (goal.target != CompressionTarget::pressure ||
                   goal.compression != Compression::isotropic))
    throw std::invalid_argument(
        "packing by dynamics: it is for isotropic compression to a pressure");
  (void)cell_shape(*this);
}

UnitCell make_packing(const PackingRequest &request,
                      const CompressionObserver &observe)
{
  request.check();
  UnitCell cell = random_start(request);
  finish_packing(cell, request, observe);
  return cell;
}

void finish_packing(UnitCell &cell,
                    const PackingRequest &request,
                    const CompressionObserver &observe)
{
  CellLaws(cell).check(cell);
  if (request.friction_during_packing >= 0)
    cell.contact.friction_coefficient = request.friction_during_packing;
  if (request.dynamics)
    pack_by_dynamics(cell, request, observe);
  else
    compress(cell, request.goal, observe);
  if (cell.contact != request.contact) {
    // Contacts that the friction of the run cannot hold slip now.
    cell.contact = request.contact;
    deform(cell, Stretch::Identity(), {});
  }
  cell.reference_volume = cell.box.volume();
  cell.last = {};
  cell.energy = {};
}
} // namespace tamp::dem
