// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/cell_shape.h>
#include <dem/deform.h>
#include <dem/packing.h>
#include <dem/random_start.h>
#include <dem/unit_cell.h>
#include <dem/value_check.h>

#include <stdexcept>

namespace tamp::dem
{
namespace
{
constexpr std::size_t most_others = 254; // a species is a byte
}

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
