// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/measures.h>

#include <algorithm>
#include <utility>

namespace tamp::dem
{
namespace
{
/// A contact with all that its laws want to know.
struct Visited {
  const ContactMemory &contact;
  Vector3 branch; ///< [m]
  PairShape<double> shape;
  double overlap; ///< [m]
  NormalMemory<double> memory;
  const PairLaws &laws;
};

/// Calls `visit` with each contact that overlaps or sticks.
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
    visit(
        Visited{contact,
                branch,
                shape,
                overlap,
                {contact.largest_overlap, contact.contact_radius, more.data()},
                laws.of(contact.pair)});
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

/// Adds the contact if it touches.
void add_force(std::vector<ContactForce> &forces, const Visited &visited)
{
  // Laws write into the memory that they are given.
  const auto [push, plastic] = std::visit(
      [&](const auto &law) {
        NormalMemory<double> memory = visited.memory;
        const NormalAnswer<double> answer =
            law(visited.overlap, visited.shape, memory);
        return std::pair(answer, law.is_plastic(visited.shape, memory));
      },
      visited.laws.normal);
  const Vector3 &tangential = visited.contact.tangential_force;
  if (push.contact_radius > 0)
    forces.push_back({visited.contact.pair,
                      visited.branch,
                      push.force,
                      tangential,
                      visited.overlap,
                      plastic,
                      slides(visited.laws.tangential, push, tangential)});
}

struct ContactEnergy {
  double elastic = 0, dissipated = 0;
};

void add_energy(ContactEnergy &sum, const Visited &visited)
{
  const NormalEnergy normal = std::visit(
      [&](const auto &law) {
        return law.energy(visited.overlap, visited.shape, visited.memory);
      },
      visited.laws.normal);
  sum.elastic += normal.elastic;
  sum.dissipated += normal.dissipated;
}

/// What the tangential and the rolling spring hold [J].
double held_in_springs(const Visited &visited)
{
  const PairLaws &laws = visited.laws;
  const NormalAnswer<double> push = std::visit(
      [&](const auto &law) {
        NormalMemory<double> memory = visited.memory;
        return law(visited.overlap, visited.shape, memory);
      },
      laws.normal);
  const Vector3 &t = visited.contact.tangential_force;
  return spring_energy(laws,
                       visited.shape,
                       push,
                       {t.x(), t.y(), t.z()},
                       visited.memory.more + laws.normal_more());
}

Matrix3 stress_of(const std::vector<ContactForce> &forces, double volume)
{
  Matrix3 sum = Matrix3::Zero();
  for (const ContactForce &c : forces)
    sum -= (c.normal_force * c.branch.normalized() - c.tangential_force) *
           c.branch.transpose();
  return sum / volume;
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
  result.coordination_number = doubled / n;
  if (n > none + one)
    result.mechanical_coordination_number = (doubled - one) / (n - none - one);
}
} // namespace

std::vector<ContactForce> contact_forces(const UnitCell &cell)
{
  std::vector<ContactForce> result;
  result.reserve(cell.contacts.size());
  for_each_contact(cell,
                   [&](const Visited &visited) { add_force(result, visited); });
  return result;
}

Matrix3 love_weber_stress(const UnitCell &cell)
{
  return stress_of(contact_forces(cell), cell.box.volume());
}

CellMeasures measure(const UnitCell &cell)
{
  std::vector<ContactForce> forces;
  forces.reserve(cell.contacts.size());
  ContactEnergy energy;
  for_each_contact(cell, [&](const Visited &visited) {
    add_energy(energy, visited); // before a law writes into its own memory
    energy.elastic += held_in_springs(visited);
    add_force(forces, visited);
  });
  CellMeasures result;
  const Matrix3 stress = stress_of(forces, cell.box.volume());
  result.stress = 0.5 * (stress + stress.transpose());
  if (const double size = stress.norm(); size > 0)
    result.asymmetry = 0.5 * (stress - stress.transpose()).norm() / size;
  for (const ContactForce &c : forces) {
    result.mean_normal_force += c.normal_force;
    result.plastic_contacts += c.plastic;
    result.sliding_contacts += c.sliding;
  }
  result.contacts = forces.size();
  result.anisotropy = anisotropies(forces);
  if (!forces.empty()) {
    result.mean_normal_force /= double(forces.size());
    result.fabric = Matrix3::Identity() / 3 + result.anisotropy.contacts / 7.5;
  }
  count_grains(cell, forces, result);
  result.backbone = find_backbone(cell, forces);
  result.rattlers = result.backbone.rattlers;
  result.relative_density = cell.relative_density();
  result.elastic_energy = energy.elastic;
  return result;
}

double elastic_energy(const UnitCell &cell)
{
  ContactEnergy energy;
  for_each_contact(cell, [&](const Visited &visited) {
    add_energy(energy, visited);
    energy.elastic += held_in_springs(visited);
  });
  return energy.elastic;
}

double plastic_loss(const UnitCell &cell)
{
  ContactEnergy energy;
  for_each_contact(
      cell, [&](const Visited &visited) { add_energy(energy, visited); });
  return energy.dissipated;
}
} // namespace tamp::dem
