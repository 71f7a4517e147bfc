// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/law_choice.h>
#include <dem/measures.h>

#include <algorithm>

namespace tamp::dem
{
namespace
{
/// Calls `visit` with each contact that overlaps: its memory, branch [m],
/// reduced radius [m] and overlap [m].
template <class Visitor>
void for_each_overlap(const UnitCell &cell, Visitor &&visit)
{
  for (const ContactMemory &memory : cell.contacts) {
    const auto [i, j] = memory.pair;
    const double a = cell.radius[i], b = cell.radius[j];
    const Vector3 branch =
        cell.box.nearest_image(cell.place[j] - cell.place[i]);
    const double overlap = a + b - branch.norm();
    if (overlap > 0)
      visit(memory, branch, a * b / (a + b), overlap);
  }
}

bool slides(const UnitCell &cell,
            double normal_force,
            const Vector3 &tangential)
{
  // The law leaves a sliding contact on Coulomb's cap up to round-off.
  constexpr double round_off = 1e-9;
  return cell.contact.tangential_law == TangentialLaw::mindlin &&
         tangential.norm() >=
             (1 - round_off) * cell.contact.friction_coefficient * normal_force;
}
} // namespace

std::vector<ContactForce> contact_forces(const UnitCell &cell)
{
  std::vector<ContactForce> result;
  result.reserve(cell.contacts.size());
  with_normal_law(cell.contact, cell.material, [&](const auto &law) {
    for_each_overlap(
        cell,
        [&](const ContactMemory &memory,
            const Vector3 &branch,
            double reduced,
            double overlap) {
          double largest = memory.largest_overlap;
          const double force = law(overlap, reduced, largest).force;
          if (force > 0)
            result.push_back({memory.pair,
                              branch,
                              force,
                              memory.tangential_force,
                              overlap,
                              law.is_plastic(reduced, largest),
                              slides(cell, force, memory.tangential_force)});
        });
  });
  return result;
}

namespace
{
Matrix3 stress_of(const std::vector<ContactForce> &forces, double volume)
{
  Matrix3 sum = Matrix3::Zero();
  for (const ContactForce &c : forces)
    sum -= (c.normal_force * c.branch.normalized() - c.tangential_force) *
           c.branch.transpose();
  return sum / volume;
}

double elastic_energy(const UnitCell &cell)
{
  double sum = 0;
  with_normal_law(cell.contact, cell.material, [&](const auto &normal) {
    with_tangential_law(cell.contact, cell.material, [&](const auto &rub) {
      for_each_overlap(
          cell,
          [&](const ContactMemory &memory,
              const Vector3 &,
              double reduced,
              double overlap) {
            sum +=
                normal.energy(overlap, reduced, memory.largest_overlap).elastic;
            const double k = rub.stiffness(memory.contact_radius);
            if (k > 0)
              sum += memory.tangential_force.squaredNorm() / (2 * k);
          });
    });
  });
  return sum;
}

void count_grains(const UnitCell &cell,
                  const std::vector<ContactForce> &forces,
                  CellMeasures &result)
{
  std::vector<unsigned> touching(cell.size(), 0);
  for (const ContactForce &c : forces) {
    ++touching[c.pair.first];
    ++touching[c.pair.second];
  }
  const double none = double(std::ranges::count(touching, 0u));
  const double one = double(std::ranges::count(touching, 1u));
  const double n = double(cell.size()), doubled = 2 * double(forces.size());
  result.rattlers = std::size_t(none + one);
  result.coordination_number = doubled / n;
  if (n > none + one)
    result.mechanical_coordination_number = (doubled - one) / (n - none - one);
}
} // namespace

Matrix3 love_weber_stress(const UnitCell &cell)
{
  return stress_of(contact_forces(cell), cell.box.volume());
}

CellMeasures measure(const UnitCell &cell)
{
  const std::vector<ContactForce> forces = contact_forces(cell);
  CellMeasures result;
  const Matrix3 stress = stress_of(forces, cell.box.volume());
  result.stress = 0.5 * (stress + stress.transpose());
  if (const double size = stress.norm(); size > 0)
    result.asymmetry = 0.5 * (stress - stress.transpose()).norm() / size;
  for (const ContactForce &c : forces) {
    const Vector3 n = c.branch.normalized();
    result.fabric += n * n.transpose();
    result.plastic_contacts += c.plastic;
    result.sliding_contacts += c.sliding;
  }
  result.contacts = forces.size();
  if (!forces.empty())
    result.fabric /= double(forces.size());
  count_grains(cell, forces, result);
  result.relative_density = cell.relative_density();
  result.elastic_energy = elastic_energy(cell);
  return result;
}
} // namespace tamp::dem
