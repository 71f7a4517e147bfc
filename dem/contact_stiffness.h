// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_contact_stiffness_h
#define dem_contact_stiffness_h

#include <vector>

namespace tamp::dem
{
class UnitCell;
struct ContactForce;

/// Which way a contact goes from where it stands.
enum class ContactSlope {
  loading, ///< further in: plastic contacts on their virgin curve are soft
  elastic  ///< out, or back in: what it did before is what it does again
};

/// Derivatives of the forces of a contact.
struct ContactStiffness {
  double normal = 0;     ///< k_n = dN / d overlap [N/m]
  double tangential = 0; ///< k_t, of a contact that sticks [N/m]
  double friction = 0;   ///< d cap / dN of the tangential force [-]
};

/// The stiffness of every contact, in their order.
/// @param contacts  contact_forces(cell)
std::vector<ContactStiffness>
contact_stiffness(const UnitCell &cell,
                  const std::vector<ContactForce> &contacts,
                  ContactSlope slope);
} // namespace tamp::dem

#endif
