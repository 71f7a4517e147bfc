// SPDX-License-Identifier: BSD-3-Clause
#include <dem/backbone.h>
#include <dem/measures.h>
#include <dem/unit_cell.h>

#include <algorithm>

namespace tamp::dem
{
namespace
{
bool has_friction(const ContactModel &contact)
{
  return contact.tangential_law != TangentialLaw::none &&
         contact.friction_coefficient > 0;
}
} // namespace

Backbone find_backbone(const UnitCell &cell,
                       const std::vector<ContactForce> &contacts)
{
  const unsigned least = has_friction(cell.contact) ? 2 : 4;
  std::vector<Pair> left;
  left.reserve(contacts.size());
  for (const ContactForce &c : contacts)
    left.push_back(c.pair);
  std::vector<unsigned> touching;
  std::size_t before;
  do {
    before = left.size();
    touching.assign(cell.size(), 0);
    for (const Pair &pair : left) {
      ++touching[pair.first];
      ++touching[pair.second];
    }
    std::erase_if(left, [&](const Pair &pair) {
      return touching[pair.first] < least || touching[pair.second] < least;
    });
  } while (left.size() < before);

  Backbone result;
  result.contacts = left.size();
  result.rattlers = std::size_t(std::ranges::count_if(
      touching, [&](unsigned count) { return count < least; }));
  if (result.rattlers < cell.size())
    result.coordination_number =
        2 * double(result.contacts) / double(cell.size() - result.rattlers);
  return result;
}
} // namespace tamp::dem
