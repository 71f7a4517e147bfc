// SPDX-License-Identifier: BSD-3-Clause
#include <dem/contact_stiffness.h>
#include <dem/measures.h>
#include <dem/six.h>
#include <dem/tangent.h>

#include <cstddef>
#include <vector>

namespace tamp::dem
{
namespace
{
constexpr double sliding_share = 0.1;

/// Sum over contacts of d^2 [k_n n (n.e.n) + (k_t - pull N/d) (e.n)_t] (x) n /
/// V.
Tangent contact_sum(const UnitCell &cell,
                    const std::vector<ContactForce> &contacts,
                    double pull)
{
  Tangent result = Tangent::Zero();
  const double volume = cell.box.volume();
  const std::vector<ContactStiffness> stiffness =
      contact_stiffness(cell, contacts, ContactSlope::loading);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const ContactForce &contact = contacts[c];
    const ContactStiffness &k = stiffness[c];
    const double d = contact.branch.norm();
    const Vector3 n = contact.branch / d;
    const double across = (contact.sliding ? sliding_share : 1) * k.tangential -
                          pull * contact.normal_force / d;
    for (int column = 0; column < 6; ++column) {
      const Vector3 along = unit_strain(column) * n;
      const Vector3 normal = along.dot(n) * n;
      const Vector3 force = k.normal * normal + across * (along - normal);
      result.col(column) += to_six(d * d / volume * force * n.transpose());
    }
  }
  return result;
}
} // namespace

Tangent voigt_stiffness(const UnitCell &cell)
{
  return contact_sum(cell, contact_forces(cell), 0);
}

Tangent stress_transport(const Matrix3 &stress)
{
  Tangent result;
  for (int column = 0; column < 6; ++column) {
    const Matrix3 strain = unit_strain(column);
    result.col(column) = to_six(stress * strain - strain.trace() * stress);
  }
  return result;
}

Tangent voigt_tangent(const UnitCell &cell)
{
  const std::vector<ContactForce> contacts = contact_forces(cell);
  return contact_sum(cell, contacts, 1) +
         stress_transport(love_weber_stress(contacts, cell.box.volume()));
}
} // namespace tamp::dem
