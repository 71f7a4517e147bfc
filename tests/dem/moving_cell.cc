// SPDX-License-Identifier: BSD-3-Clause
#include <tests/dem/moving_cell.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tamp::dem::test
{
SmallMotion no_motion(std::size_t grains)
{
  const std::vector<Vector3> rest(grains, Vector3::Zero());
  return {{}, rest, rest};
}

SmallMotion random_motion(std::size_t grains,
                          std::uint64_t seed,
                          double size,
                          double length)
{
  RandomNumbers random(seed);
  const auto any = [&] { return size * (2 * random.next() - 1); };
  const auto vector = [&] {
    const double x = any(), y = any(), z = any();
    return Vector3(x, y, z);
  };
  SmallMotion motion = no_motion(grains);
  for (std::size_t i = 0; i < grains; ++i) {
    motion.relative[i] = vector();
    motion.rolled[i] = vector();
  }
  for (int k = 0; k < 9; ++k)
    motion.affine.stretch(k / 3, k % 3) += any() / length;
  return motion;
}

namespace
{
NormalAnswer<double> push_by_hand(NormalLaw law,
                                  const PairMaterial &material,
                                  double overlap,
                                  const PairShape<double> &shape,
                                  double &largest)
{
  NormalMemory<double> memory = {largest, 0};
  const NormalAnswer<double> answer =
      law == NormalLaw::hertz
          ? Hertz{material.effective_modulus}(overlap, shape, memory)
          : ThorntonNing(material.effective_modulus,
                         material.limiting_pressure)(overlap, shape, memory);
  largest = memory.largest_overlap;
  return answer;
}

ContactMemory memory_of(const UnitCell &cell, Pair pair)
{
  for (const ContactMemory &memory : cell.contacts)
    if (memory.pair == pair)
      return memory;
  return {pair};
}

/// A tangential force and the work lost on the way to it.
struct Rub {
  Vector3 force = Vector3::Zero(); // [N]
  double lost = 0;                 // [J]
};

/// T^2 / (2 k_t) [J]; 0 without a contact radius.
double stored(double force, double shear_modulus, double radius)
{
  return radius > 0 ? force * force / (16 * shear_modulus * radius) : 0;
}

/// The old force, turned with the contact, shrunk and pushed on to the cap. On
/// the way the energy of the old force becomes that of the kept one, then that
/// of the cap if it is lower; then the contact slides.
Rub rub_by_hand(const ContactMemory &old,
                const Vector3 &normal,
                const Vector3 &slip,
                double spin,
                double a,
                double shear_modulus,
                double cap)
{
  Vector3 rub = old.tangential_force;
  const double size = rub.norm();
  const double before = stored(size, shear_modulus, old.contact_radius);
  if (a == 0)
    return {Vector3::Zero(), before};
  rub -= rub.dot(normal) * normal;
  if (size > 0)
    rub *= size / rub.norm();
  rub += spin * normal.cross(rub);
  if (a < old.contact_radius)
    rub *= a / old.contact_radius;
  const double k = 8 * shear_modulus * a, kept = rub.norm();
  double lost = before - stored(kept, shear_modulus, a);
  rub += k * (slip - slip.dot(normal) * normal);
  if (rub.norm() > cap) {
    lost += cap * (rub.norm() - cap) / k;
    rub *= cap / rub.norm();
  }
  if (kept > cap)
    lost += (kept - cap) * (kept - cap) / (2 * k);
  return {rub, lost};
}

/// Adds the contact of one pair, l from the first grain to the second. Answers
/// whether they overlap.
bool add_contact(const UnitCell &cell,
                 const SmallMotion &motion,
                 Pair pair,
                 const Vector3 &before,
                 Oracle &sum)
{
  const auto [i, j] = pair;
  const Vector3 change = motion.relative[j] - motion.relative[i] +
                         motion.affine.stretch * before - before;
  const Vector3 l = before + change;
  const double ri = cell.radius[i], rj = cell.radius[j], d = l.norm();
  const double overlap = ri + rj - d;
  if (overlap <= 0)
    return false;
  const PairMaterial material =
      pair_material(cell.material_of(i), cell.material_of(j));
  const ContactMemory old = memory_of(cell, pair);
  ContactMemory now = old;
  const NormalAnswer<double> push = push_by_hand(cell.contact.normal_law,
                                                 material,
                                                 overlap,
                                                 cell.shape(pair),
                                                 now.largest_overlap);
  const Vector3 normal = l / d;
  const Vector3 pi = motion.rolled[i] / ri, pj = motion.rolled[j] / rj;
  const double arm_i = ri / (ri + rj) * d, arm_j = rj / (ri + rj) * d;
  const Vector3 slip =
      change -
      (motion.rolled[i] + motion.rolled[j]).cross(before + l) / (2 * (ri + rj));
  auto [rub, lost] =
      rub_by_hand(old,
                  normal,
                  slip,
                  (ri * pi + rj * pj).dot(normal) / (ri + rj),
                  push.contact_radius,
                  material.effective_shear_modulus,
                  cell.contact.friction_coefficient * push.force);
  if (cell.contact.tangential_law == TangentialLaw::none) {
    rub.setZero();
    lost = 0;
  }
  sum.totals.lost_work += lost;
  now.contact_radius = push.contact_radius;
  now.tangential_force = rub;
  sum.memories.push_back(now);
  const Vector3 on_first = rub - push.force * normal;
  sum.totals.contacts += push.force > 0;
  sum.totals.normal_force += push.force;
  sum.totals.too_deep |= overlap > 2 * cell.shape(pair).reduced_radius;
  sum.totals.moment -= on_first * l.transpose();
  sum.force[i] += on_first;
  sum.force[j] -= on_first;
  sum.torque[i] += arm_i / ri * normal.cross(rub);
  sum.torque[j] += arm_j / rj * normal.cross(rub);
  return true;
}

/// Books what the contact of a pair that no longer overlaps had stored.
void add_opening(const UnitCell &cell, Pair pair, Oracle &sum)
{
  const ContactMemory old = memory_of(cell, pair);
  const double shear_modulus =
      pair_material(cell.material_of(pair.first), cell.material_of(pair.second))
          .effective_shear_modulus;
  if (cell.contact.tangential_law != TangentialLaw::none)
    sum.totals.lost_work +=
        stored(old.tangential_force.norm(), shear_modulus, old.contact_radius);
}
} // namespace

UnitCell with_history(UnitCell cell, const ContactModel &contact, double size)
{
  cell.contact = contact;
  cell.contacts.clear();
  cell.more_memory.clear();
  LaidOut<double> laid_out(cell, InstructionSet::scalar);
  for (std::uint64_t seed : {501, 502}) {
    SmallMotion motion =
        random_motion(cell.size(), seed, size, cell.mean_radius());
    laid_out.sweep(motion, Memory::written);
  }
  return laid_out.remembering();
}

Oracle by_hand(const UnitCell &cell, const SmallMotion &motion)
{
  const std::size_t n = cell.size();
  Oracle sum;
  sum.force.assign(n, Vector3::Zero());
  sum.torque.assign(n, Vector3::Zero());
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = i + 1; j < n; ++j) {
      bool overlap = false;
      for (int k = 0; k < 27; ++k) {
        Vector3 s = cell.place[j] - cell.place[i];
        for (int a = 0; a < 3; ++a)
          s[a] -= std::floor(s[a]);
        const Vector3 image(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        overlap |=
            add_contact(cell, motion, {i, j}, cell.box.h * (s + image), sum);
      }
      if (!overlap)
        add_opening(cell, {i, j}, sum);
    }
  return sum;
}

double largest(std::span<const Vector3> values)
{
  double result = 0;
  for (const Vector3 &value : values)
    result = std::max(result, value.norm());
  return result;
}

double largest_difference(std::span<const Vector3> a,
                          std::span<const Vector3> b)
{
  if (a.size() != b.size())
    return std::numeric_limits<double>::infinity();
  double result = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    result = std::max(result, (a[k] - b[k]).norm());
  return result;
}
} // namespace tamp::dem::test
