// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_growth.h>
#include <dem/cell_laws.h>
#include <dem/grain_growth.h>
#include <dem/measures.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

namespace tamp::dem
{
namespace
{
std::vector<GrownContact> grown_contacts(const UnitCell &cell)
{
  std::vector<GrownContact> contacts;
  contacts.reserve(cell.contacts.size());
  for (const ContactMemory &memory : cell.contacts) {
    const auto [i, j] = memory.pair;
    contacts.push_back(
        {{memory.pair, cell.box.nearest_image(cell.place[j] - cell.place[i])},
         memory.largest_overlap});
  }
  return contacts;
}

/// Takes new radii over. Pairs on the list of neighbours reached each other by
/// its skin; of that they have used up what two grains grew.
void take_radii(UnitCell &cell, const std::vector<double> &radius)
{
  double growth = 0;
  for (std::size_t i = 0; i < cell.size(); ++i)
    growth = std::max(growth, radius[i] - cell.radius[i]);
  if (growth <= 0)
    return;
  if (cell.initial_radius.empty())
    cell.initial_radius = cell.radius;
  cell.radius = radius;
  cell.neighbours.skin -= 2 * growth;
}
} // namespace

bool grains_grow(const UnitCell &cell)
{
  return cell.contact.normal_law == NormalLaw::mdr;
}

void grow(UnitCell &cell)
{
  if (!grains_grow(cell))
    return;
  const CellLaws laws(cell);
  const Mdr &law = std::get<Mdr>(laws.of_kind(0).normal);
  // The numbers of the normal law come first among those of a contact.
  const std::size_t all = laws.more();
  std::vector<double> own;
  own.reserve(cell.contacts.size() * Mdr::more);
  for (std::size_t c = 0; c < cell.contacts.size(); ++c) {
    const double *more = cell.more_memory.data() + c * all;
    own.insert(own.end(), more, more + Mdr::more);
  }
  const std::vector<double> &initial =
      cell.initial_radius.empty() ? cell.radius : cell.initial_radius;
  const GrainGrowth growth = grow_grains(law,
                                         {cell.radius, initial},
                                         grown_contacts(cell),
                                         own,
                                         cell.contact.bulk_onset);
  for (std::size_t c = 0; c < cell.contacts.size(); ++c)
    std::copy_n(growth.more.data() + c * Mdr::more,
                Mdr::more,
                cell.more_memory.data() + c * all);
  take_radii(cell, growth.radius);
}

double unstored_work(const UnitCell &cell, double kinetic_energy)
{
  const EnergyAccount &energy = cell.energy;
  return energy.work - energy.friction_dissipation -
         energy.damping_dissipation - survey_contacts(cell).elastic_energy -
         kinetic_energy;
}
} // namespace tamp::dem
