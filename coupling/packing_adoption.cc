// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/packing_adoption.h>
#include <dem/deform.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace tamp::coupling
{
namespace
{
/// The same box, and grains at rest in it.
void settle(dem::UnitCell &cell)
{
  constexpr int most_rests = 20;
  dem::Driving driving;
  // Forces of grains that barely touch: a billionth of E d^2, of the softest.
  const double diameter = 2 * cell.mean_radius();
  driving.quasi_static.force_floor =
      1e-9 * diameter * diameter *
      std::ranges::min(cell.materials, {}, &dem::GrainMaterial::youngs_modulus)
          .youngs_modulus;
  for (int k = 0; k < most_rests; ++k)
    if (const auto answer = deform(cell, dem::Stretch::Identity(), driving);
        answer.outcome == dem::Outcome::settled)
      return;
    else if (answer.outcome == dem::Outcome::diverged)
      break;
  throw std::runtime_error(
      "the stored packing does not come to rest under the contact model of "
      "this run");
}
} // namespace

History adopt_packing(dem::UnitCell &cell,
                      const std::vector<dem::GrainMaterial> &materials,
                      const dem::ContactModel &contact)
{
  for (const std::uint8_t species : cell.species)
    if (species >= materials.size())
      throw std::invalid_argument("the stored packing has grains of " +
                                  std::to_string(cell.materials.size()) +
                                  " materials, this run has " +
                                  std::to_string(materials.size()));
  dem::ContactModel same_laws = cell.contact;
  same_laws.friction_coefficient = contact.friction_coefficient;
  History history = History::kept;
  if (cell.materials != materials || same_laws != contact ||
      cell.contacts.empty())
    history = History::forgotten;
  else if (cell.contact != contact)
    history = History::slipped;
  cell.materials = materials;
  cell.contact = contact;
  if (history == History::forgotten) {
    cell.contacts.clear();
    cell.more_memory.clear();
    // What they displaced is forgotten, too.
    if (!cell.initial_radius.empty())
      cell.radius = std::exchange(cell.initial_radius, {});
  }
  cell.velocity.clear();
  cell.spin.clear();
  cell.last = {};
  if (history != History::kept)
    settle(cell);
  cell.reference_volume = cell.box.volume();
  cell.last = {};
  cell.energy = {};
  return history;
}
} // namespace tamp::coupling
