// SPDX-License-Identifier: BSD-3-Clause
#include <dem/anisotropy.h>
#include <dem/measures.h>

#include <algorithm>

namespace tamp::dem
{
namespace
{
/// The symmetric part without its trace.
Matrix3 deviator(const Matrix3 &tensor)
{
  return 0.5 * (tensor + tensor.transpose()) -
         tensor.trace() / 3 * Matrix3::Identity();
}
} // namespace

Anisotropies anisotropies(const std::vector<ContactForce> &contacts)
{
  Anisotropies result;
  if (contacts.empty())
    return result;
  const double count = double(contacts.size());
  Matrix3 fabric = Matrix3::Zero();
  for (const ContactForce &c : contacts)
    fabric += c.branch * c.branch.transpose() / c.branch.squaredNorm();
  result.contacts = 7.5 * deviator(fabric / count);

  // Means over directions, not over contacts: a direction with many contacts
  // does not count more. The floor is met only with a handful of contacts.
  constexpr double least_density = 0.1;
  Matrix3 normal = Matrix3::Zero(), tangential = Matrix3::Zero();
  for (const ContactForce &c : contacts) {
    const Vector3 n = c.branch.normalized();
    const double density =
        std::max(least_density, 1 + n.dot(result.contacts * n));
    const Vector3 share = n / density;
    normal += (c.normal_force * n) * share.transpose();
    tangential -= c.tangential_force * share.transpose();
  }
  const double mean = normal.trace(); // f_0, times the number of contacts
  if (mean > 0) {
    result.normal = 7.5 / mean * deviator(normal);
    result.tangential = 5 / mean * deviator(tangential);
  }
  return result;
}
} // namespace tamp::dem
