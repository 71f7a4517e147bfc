// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/measures.h>

#include <algorithm>

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

/// Adds what a contact says: its energy, and its force if it touches.
void add(ContactSurvey &survey, const Visited &visited)
{
  const Vector3 &t = visited.contact.tangential_force;
  std::visit(
      [&](const auto &law) {
        // Before the law writes into the memory that it is given.
        const NormalEnergy energy =
            law.energy(visited.overlap, visited.shape, visited.memory);
        survey.plastic_loss += energy.dissipated;
        survey.elastic_energy += energy.elastic;
        NormalMemory<double> memory = visited.memory;
        const NormalAnswer<double> push =
            law(visited.overlap, visited.shape, memory);
        survey.elastic_energy +=
            spring_energy(visited.laws,
                          visited.shape,
                          push,
                          {t.x(), t.y(), t.z()},
                          visited.memory.more + visited.laws.normal_more());
        if (push.contact_radius > 0)
          survey.forces.push_back({visited.contact.pair,
                                   visited.branch,
                                   push.force,
                                   t,
                                   visited.overlap,
                                   law.is_plastic(visited.shape, memory),
                                   slides(visited.laws.tangential, push, t)});
      },
      visited.laws.normal);
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

ContactSurvey survey_contacts(const UnitCell &cell)
{
  ContactSurvey survey;
  survey.forces.reserve(cell.contacts.size());
  for_each_contact(cell, [&](const Visited &visited) { add(survey, visited); });
  return survey;
}

std::vector<ContactForce> contact_forces(const UnitCell &cell)
{
  return survey_contacts(cell).forces;
}

Matrix3 love_weber_stress(std::span<const ContactForce> forces, double volume)
{
  Matrix3 sum = Matrix3::Zero();
  for (const ContactForce &c : forces)
    sum -= (c.normal_force * c.branch.normalized() - c.tangential_force) *
           c.branch.transpose();
  return sum / volume;
}

Matrix3 love_weber_stress(const UnitCell &cell)
{
  return love_weber_stress(survey_contacts(cell).forces, cell.box.volume());
}

CellMeasures measure(const UnitCell &cell)
{
  const ContactSurvey survey = survey_contacts(cell);
  const std::vector<ContactForce> &forces = survey.forces;
  CellMeasures result;
  const Matrix3 stress = love_weber_stress(forces, cell.box.volume());
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
  result.elastic_energy = survey.elastic_energy;
  return result;
}
} // namespace tamp::dem
