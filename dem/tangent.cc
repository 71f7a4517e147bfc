// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/measures.h>
#include <dem/tangent.h>

#include <algorithm>
#include <array>
#include <utility>

namespace tamp::dem
{
namespace
{
constexpr double sliding_share = 0.1;
constexpr std::array<std::pair<int, int>, 6> component = {
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

Matrix3 unit_strain(int k)
{
  const auto [a, b] = component[k];
  Matrix3 strain = Matrix3::Zero();
  strain(a, b) = strain(b, a) = 1;
  return strain;
}

void add_stress(Tangent &tangent, int column, const Matrix3 &stress)
{
  for (int k = 0; k < 6; ++k) {
    const auto [a, b] = component[k];
    tangent(k, column) += 0.5 * (stress(a, b) + stress(b, a));
  }
}

struct PairStiffness {
  double normal, tangential; ///< k_n, k_t [N/m]
};

/// Stiffness of a contact for further loading.
PairStiffness pair_stiffness(const UnitCell &cell,
                             const ContactForce &contact,
                             const PairLaws &laws,
                             NormalMemory<double> memory)
{
  const PairShape<double> shape = cell.shape(contact.pair);
  PairStiffness k{};
  const double radius = std::visit(
      [&](const auto &law) {
        k.normal = law.loading_slope(contact.overlap, shape, memory);
        return law(contact.overlap, shape, memory).contact_radius;
      },
      laws.normal);
  k.tangential = std::visit(
      [&](const auto &law) { return law.stiffness(radius); }, laws.tangential);
  if (contact.sliding)
    k.tangential *= sliding_share;
  return k;
}

/// Sum over contacts of d^2 [k_n n (n.e.n) + (k_t - pull N/d) (e.n)_t] (x) n /
/// V.
Tangent contact_sum(const UnitCell &cell, double pull)
{
  Tangent result = Tangent::Zero();
  const double volume = cell.box.volume();
  const CellLaws laws(cell);
  std::vector<double> more(laws.more());
  auto memory = cell.contacts.begin();
  for (const ContactForce &contact : contact_forces(cell)) {
    while (memory->pair < contact.pair)
      ++memory;
    const auto k_memory = memory - cell.contacts.begin();
    std::copy_n(cell.more_memory.data() + std::size_t(k_memory) * more.size(),
                more.size(),
                more.data());
    const PairStiffness k = pair_stiffness(
        cell,
        contact,
        laws.of(contact.pair),
        {memory->largest_overlap, memory->contact_radius, more.data()});
    const double d = contact.branch.norm();
    const Vector3 n = contact.branch / d;
    const double turning = pull * contact.normal_force / d;
    for (int column = 0; column < 6; ++column) {
      const Vector3 along = unit_strain(column) * n;
      const Vector3 normal = along.dot(n) * n;
      const Vector3 force =
          k.normal * normal + (k.tangential - turning) * (along - normal);
      add_stress(result, column, d * d / volume * force * n.transpose());
    }
  }
  return result;
}
} // namespace

Tangent voigt_stiffness(const UnitCell &cell)
{
  return contact_sum(cell, 0);
}

Tangent voigt_tangent(const UnitCell &cell)
{
  Tangent result = contact_sum(cell, 1);
  const Matrix3 stress = love_weber_stress(cell);
  for (int column = 0; column < 6; ++column) {
    const Matrix3 strain = unit_strain(column);
    add_stress(result, column, stress * strain - strain.trace() * stress);
  }
  return result;
}
} // namespace tamp::dem
