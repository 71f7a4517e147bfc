// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/measures.h>

#include <algorithm>

namespace tamp::dem
{
namespace
{
/// Calls `visit` with each contact that overlaps or sticks: its memory, its
/// branch [m], the pair's shape, its overlap [m] and its laws.
template <class Visitor>
void for_each_contact(const UnitCell &cell, Visitor &&visit)
{
  const CellLaws laws(cell);
  std::vector<double> more(laws.more());
  for (std::size_t k = 0; k < cell.contacts.size(); ++k) {
    const ContactMemory &contact = cell.contacts[k];
    const auto [i, j] = contact.pair;
    const Vector3 branch =
        cell.box.nearest_image(cell.place[j] - cell.place[i]);
    const PairShape<double> shape = cell.shape(contact.pair);
    const double overlap = shape.radius_sum - branch.norm();
    if (overlap <= 0 && contact.contact_radius <= 0)
      continue;
    std::copy_n(
        cell.more_memory.data() + k * more.size(), more.size(), more.data());
    visit(contact,
          branch,
          shape,
          overlap,
          NormalMemory<double>{
              contact.largest_overlap, contact.contact_radius, more.data()},
          laws.of(contact.pair));
  }
}

bool slides(const AnyTangentialLaw &law,
            const NormalAnswer<double> &push,
            const Vector3 &tangential)
{
  // The law leaves a sliding contact on Coulomb's cap up to round-off.
  constexpr double round_off = 1e-6;
  const double cap =
      std::visit([&](const auto &l) { return l.cap(push); }, law);
  return cap > 0 && tangential.norm() >= (1 - round_off) * cap;
}
} // namespace

std::vector<ContactForce> contact_forces(const UnitCell &cell)
{
  std::vector<ContactForce> result;
  result.reserve(cell.contacts.size());
  for_each_contact(
      cell,
      [&](const ContactMemory &contact,
          const Vector3 &branch,
          const PairShape<double> &shape,
          double overlap,
          NormalMemory<double> memory,
          const PairLaws &laws) {
        const auto [push, plastic] = std::visit(
            [&](const auto &law) {
              const NormalAnswer<double> answer = law(overlap, shape, memory);
              return std::pair(answer, law.is_plastic(shape, memory));
            },
            laws.normal);
        if (push.contact_radius > 0)
          result.push_back(
              {contact.pair,
               branch,
               push.force,
               contact.tangential_force,
               overlap,
               plastic,
               slides(laws.tangential, push, contact.tangential_force)});
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

struct ContactEnergy {
  double elastic = 0, dissipated = 0;
};

ContactEnergy contact_energy(const UnitCell &cell)
{
  ContactEnergy sum;
  for_each_contact(
      cell,
      [&](const ContactMemory &contact,
          const Vector3 &,
          const PairShape<double> &shape,
          double overlap,
          NormalMemory<double> memory,
          const PairLaws &laws) {
        const NormalEnergy normal = std::visit(
            [&](const auto &law) { return law.energy(overlap, shape, memory); },
            laws.normal);
        sum.elastic += normal.elastic;
        sum.dissipated += normal.dissipated;
        const double k = std::visit(
            [&](const auto &law) {
              return law.stiffness(contact.contact_radius);
            },
            laws.tangential);
        if (k > 0)
          sum.elastic += contact.tangential_force.squaredNorm() / (2 * k);
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
  result.elastic_energy = contact_energy(cell).elastic;
  return result;
}
double plastic_loss(const UnitCell &cell)
{
  return contact_energy(cell).dissipated;
}
} // namespace tamp::dem
