// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/contact_stiffness.h>
#include <dem/measures.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cstddef>

namespace tamp::dem
{
namespace
{
ContactStiffness stiffness(const PairLaws &laws,
                           double overlap,
                           const PairShape<double> &shape,
                           NormalMemory<double> memory)
{
  ContactStiffness k;
  const NormalAnswer<double> push = std::visit(
      [&](const auto &law) {
        k.normal = law.loading_slope(overlap, shape, memory);
        return law(overlap, shape, memory);
      },
      laws.normal);
  std::visit(
      [&](const auto &law) {
        const double cap = law.cap(push);
        if (cap <= 0)
          return; // smooth
        k.tangential = law.stiffness(push.contact_radius);
        NormalAnswer<double> harder = push; // caps are linear in the force
        harder.force += cap;
        k.friction = (law.cap(harder) - cap) / cap;
      },
      laws.tangential);
  return k;
}
/// Where the contact counts as having been, so that it shows the wanted slope.
double largest_overlap(double largest,
                       double overlap,
                       double radius_sum,
                       ContactSlope slope)
{
  // A contact that has been further in, by a hair, loads as it unloads. One
  // that has not is on its virgin curve; the memory is as exact as the sweep
  // that wrote it, 1e-7 in single precision.
  constexpr double hair = 1e-12, memory = 1e-7;
  if (slope == ContactSlope::elastic)
    return std::max(largest, overlap + hair * radius_sum);
  return largest - overlap > memory * radius_sum ? largest : overlap;
}
} // namespace

std::vector<ContactStiffness>
contact_stiffness(const UnitCell &cell,
                  const std::vector<ContactForce> &contacts,
                  ContactSlope slope)
{
  const CellLaws laws(cell);
  std::vector<double> more(laws.more());
  std::vector<ContactStiffness> result;
  result.reserve(contacts.size());
  std::size_t k = 0;
  for (const ContactForce &contact : contacts) {
    while (cell.contacts[k].pair < contact.pair)
      ++k;
    std::copy_n(
        cell.more_memory.data() + k * more.size(), more.size(), more.data());
    const ContactMemory &memory = cell.contacts[k];
    const PairShape<double> shape = cell.shape(contact.pair);
    const double largest = largest_overlap(
        memory.largest_overlap, contact.overlap, shape.radius_sum, slope);
    result.push_back(stiffness(laws.of(contact.pair),
                               contact.overlap,
                               shape,
                               {largest, memory.contact_radius, more.data()}));
  }
  return result;
}
} // namespace tamp::dem
