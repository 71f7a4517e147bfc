// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/law_choice.h>
#include <dem/random_numbers.h>
#include <dem/sweep_layout.h>
#include <tests/dem/sample_cells.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <vector>

namespace tamp::dem
{
namespace
{
/// A small cell of overlapping grains, laid out and moving at random.
struct Moving {
  UnitCell cell;
  SweepLayout layout;
  AffineMotion affine;

  Moving(std::uint64_t seed, const ContactModel &contact)
      : cell(with(test::random_cell(60, seed), contact)),
        layout(cell), affine{cell.box.h, Matrix3::Zero()}
  {
    layout.list_pairs(cell.neighbours, cell.box, cell.place, cell.contacts);
    RandomNumbers random(seed + 100);
    const auto any = [&random] { return 2e-8 * (2 * random.next() - 1); };
    for (GrainRow &row : layout.rows())
      for (int k : {0, 1, 2, 4, 5, 6})
        row.motion[k] = any();
    for (int k = 0; k < 9; ++k)
      affine.gradient(k / 3, k % 3) = 1e4 * any();
  }

  static UnitCell with(UnitCell cell, const ContactModel &contact)
  {
    cell.contact = contact;
    return cell;
  }

  std::vector<Vector3> forces() const { return parts(0); }
  /// Torque over radius.
  std::vector<Vector3> torques() const { return parts(4); }

  std::vector<Vector3> parts(int offset) const
  {
    std::vector<Vector3> result;
    for (const GrainRow &row : layout.rows())
      result.emplace_back(row.force + offset);
    return result;
  }
};

double largest(const std::vector<Vector3> &values)
{
  double result = 0;
  for (const Vector3 &value : values)
    result = std::max(result, value.norm());
  return result;
}

double largest_difference(const std::vector<Vector3> &a,
                          const std::vector<Vector3> &b)
{
  double result = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    result = std::max(result, (a[k] - b[k]).norm());
  return result;
}

/// Forces and torques straight from the textbook: every pair, every image.
struct Oracle {
  std::vector<Vector3> force, torque; // [N], torque over radius [N]
  std::size_t contacts = 0;
};

Oracle by_hand(const Moving &moving)
{
  const UnitCell &cell = moving.cell;
  const std::size_t n = cell.size();
  Oracle sum{std::vector<Vector3>(n, Vector3::Zero()),
             std::vector<Vector3>(n, Vector3::Zero())};
  const double mu = cell.contact.friction_coefficient;
  const auto visit = [&](std::uint32_t i, std::uint32_t j, const Vector3 &l) {
    const double ri = cell.radius[i], rj = cell.radius[j], d = l.norm();
    const double overlap = ri + rj - d, reduced = ri * rj / (ri + rj);
    if (overlap <= 0)
      return;
    ContactMemory old{{i, j}};
    for (const ContactMemory &memory : cell.contacts)
      if (memory.pair == old.pair)
        old = memory;
    double top = old.largest_overlap;
    const auto [push, a] =
        with_normal_law(cell.contact, cell.material, [&](const auto &law) {
          return law(overlap, reduced, top);
        });
    const Vector3 normal = l / d;
    const auto rows = moving.layout.rows();
    const Vector3 ui(rows[i].motion), uj(rows[j].motion);
    const Vector3 pi = Vector3(rows[i].motion + 4) / ri; // rotations
    const Vector3 pj = Vector3(rows[j].motion + 4) / rj;
    const double arm_i = ri / (ri + rj) * d, arm_j = rj / (ri + rj) * d;
    const Vector3 slip = uj - ui + moving.affine.gradient * l -
                         (arm_i * pi + arm_j * pj).cross(normal);
    Vector3 rub = old.tangential_force;
    const double size = rub.norm();
    rub -= rub.dot(normal) * normal;
    if (size > 0)
      rub *= size / rub.norm();
    rub += 0.5 * (pi + pj).dot(normal) * normal.cross(rub);
    if (a < old.contact_radius)
      rub *= a / old.contact_radius;
    rub += 8 * cell.material.effective_shear_modulus() * a *
           (slip - slip.dot(normal) * normal);
    if (rub.norm() > mu * push)
      rub *= mu * push / rub.norm();
    if (cell.contact.tangential_law == TangentialLaw::none || push == 0)
      rub.setZero();
    sum.contacts += push > 0;
    sum.force[i] += rub - push * normal;
    sum.force[j] -= rub - push * normal;
    sum.torque[i] += arm_i / ri * normal.cross(rub);
    sum.torque[j] += arm_j / rj * normal.cross(rub);
  };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = i + 1; j < n; ++j)
      for (int k = 0; k < 27; ++k) {
        Vector3 s = cell.place[j] - cell.place[i];
        for (int a = 0; a < 3; ++a)
          s[a] -= std::floor(s[a]);
        const Vector3 image(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        visit(i, j, cell.box.h * (s + image));
      }
  return sum;
}

std::vector<ContactModel> all_models()
{
  std::vector<ContactModel> models;
  for (NormalLaw normal : {NormalLaw::hertz, NormalLaw::thornton_ning})
    for (TangentialLaw tangential :
         {TangentialLaw::none, TangentialLaw::mindlin})
      models.push_back({normal, tangential, 0.3, 0.5e9});
  return models;
}

TEST(Sweep, AgreesWithTryingAllPairsAndImages)
{
  constexpr double round_off = 1e-11; // of some ten contacts a grain
  for (const ContactModel &model : all_models())
    for (std::uint64_t seed : {1, 2, 3})
      for (Memory memory : {Memory::frozen, Memory::written}) {
        Moving moving(seed, model);
        const Oracle wanted = by_hand(moving);
        const SweepTotals totals = moving.layout.sweep(moving.affine, memory);
        const double size = largest(wanted.force);
        EXPECT_EQ(totals.contacts, wanted.contacts);
        EXPECT_GT(totals.contacts, 40u); // there is something to compare
        EXPECT_LT(largest_difference(moving.forces(), wanted.force),
                  round_off * size);
        EXPECT_LT(largest_difference(moving.torques(), wanted.torque),
                  round_off * size);
      }
}

TEST(Sweep, ActionIsReaction)
{
  Moving moving(4, {});
  moving.layout.sweep(moving.affine, Memory::frozen);
  Vector3 sum = Vector3::Zero();
  for (const Vector3 &force : moving.forces())
    sum += force;
  EXPECT_LT(sum.norm(), 1e-12 * largest(moving.forces())); // round-off
}

TEST(Sweep, FrozenMemoryIsNotTouched)
{
  Moving moving(5, {});
  const auto blocks = moving.layout.contacts().blocks();
  const std::vector<ContactBlock> before(blocks.begin(), blocks.end());
  moving.layout.sweep(moving.affine, Memory::frozen);
  EXPECT_EQ(0, std::memcmp(before.data(), blocks.data(), blocks.size_bytes()));
  moving.layout.sweep(moving.affine, Memory::written);
  EXPECT_NE(0, std::memcmp(before.data(), blocks.data(), blocks.size_bytes()));
}

TEST(Sweep, FrozenTwiceIsFrozenOnce)
{
  Moving moving(6, {});
  moving.layout.sweep(moving.affine, Memory::frozen);
  const std::vector<Vector3> once = moving.forces();
  moving.layout.sweep(moving.affine, Memory::frozen);
  EXPECT_EQ(once, moving.forces());
}

TEST(Sweep, WritingMemoryDoesNotChangeTheForces)
{
  Moving moving(7, {});
  moving.layout.sweep(moving.affine, Memory::frozen);
  const std::vector<Vector3> trial = moving.forces();
  moving.layout.sweep(moving.affine, Memory::written);
  EXPECT_EQ(trial, moving.forces());
}

TEST(Sweep, WrittenStateAtRestGivesTheSameForces)
{
  Moving moving(8, {});
  moving.layout.sweep(moving.affine, Memory::written);
  const std::vector<Vector3> force = moving.forces(), torque = moving.torques();
  for (GrainRow &row : moving.layout.rows())
    std::fill_n(row.motion, 8, 0.0);
  moving.affine.gradient.setZero();
  moving.layout.sweep(moving.affine, Memory::frozen);
  const double tolerance = 1e-12 * largest(force); // round-off of the caps
  EXPECT_LT(largest_difference(force, moving.forces()), tolerance);
  EXPECT_LT(largest_difference(torque, moving.torques()), tolerance);
}

TEST(Sweep, AffineMotionWithoutFluctuationIsGradientTimesBranch)
{
  // The same slip, said once by the gradient and once by the motions.
  UnitCell cell = test::random_cell(60, 9);
  std::vector<Vector3> answers[2];
  // Of one contact only: motions of periodic grains cannot be affine.
  cell.contacts.resize(1);
  const auto [i, j] = cell.contacts[0].pair;
  const Vector3 branch = cell.box.nearest_image(cell.place[j] - cell.place[i]);
  cell.radius = {cell.radius[i], cell.radius[j]};
  cell.place = {cell.place[i], cell.place[j]};
  cell.contacts[0].pair = {0, 1};
  Matrix3 gradient = Matrix3::Zero();
  gradient(0, 1) = 2e-4;
  for (int way : {0, 1}) {
    cell.neighbours = {};
    SweepLayout layout(cell);
    layout.list_pairs(cell.neighbours, cell.box, cell.place, cell.contacts);
    AffineMotion affine{cell.box.h, Matrix3::Zero()};
    const Vector3 moved = gradient * branch;
    if (way == 0)
      affine.gradient = gradient;
    else
      std::copy_n(moved.data(), 3, layout.rows()[1].motion);
    layout.sweep(affine, Memory::frozen);
    for (const GrainRow &row : layout.rows())
      answers[way].emplace_back(row.force);
  }
  EXPECT_LT(largest_difference(answers[0], answers[1]),
            1e-12 * largest(answers[0]));
}

/// Two touching grains of different size in a wide box.
UnitCell two_grains()
{
  UnitCell cell;
  cell.box.h = 1e-3 * Matrix3::Identity();
  cell.radius = {1e-4, 0.7e-4};
  const Vector3 normal = Vector3(2, -1, 2) / 3;
  cell.place = {Vector3(.9, .1, .95), Vector3(.9, .1, .95) + .1699 * normal};
  return cell;
}

TEST(Sweep, TwoGrainsConserveAngularMomentum)
{
  UnitCell cell = two_grains();
  SweepLayout layout(cell);
  layout.list_pairs(cell.neighbours, cell.box, cell.place, cell.contacts);
  layout.rows()[0].motion[1] = 3e-10;
  layout.rows()[1].motion[6] = 2e-10;
  layout.sweep({cell.box.h, Matrix3::Zero()}, Memory::frozen);
  const auto rows = layout.rows();
  const Vector3 on_second(rows[1].force);
  const Vector3 first(rows[0].force + 4), second(rows[1].force + 4);
  EXPECT_GT(first.norm(), 0);
  // The same tangential force at both ends: torque over radius is equal.
  EXPECT_EQ(first, second);
  const Vector3 branch = cell.box.nearest_image(cell.place[1] - cell.place[0]);
  const Vector3 spin = cell.radius[0] * first + cell.radius[1] * second;
  const Vector3 orbit = branch.cross(on_second);
  EXPECT_LT((spin + orbit).norm(), 1e-12 * orbit.norm());
}

TEST(Sweep, RollingTogetherDoesNotSlip)
{
  // Both grains and the pair turn as one rigid body.
  UnitCell cell = two_grains();
  SweepLayout layout(cell);
  layout.list_pairs(cell.neighbours, cell.box, cell.place, cell.contacts);
  const Vector3 turn(1e-5, 2e-5, -3e-5);
  const Vector3 branch = cell.box.nearest_image(cell.place[1] - cell.place[0]);
  const Vector3 moved = turn.cross(branch);
  std::copy_n(moved.data(), 3, layout.rows()[1].motion);
  for (int i : {0, 1})
    for (int k = 0; k < 3; ++k)
      layout.rows()[i].motion[4 + k] = cell.radius[i] * turn[k];
  layout.sweep({cell.box.h, Matrix3::Zero()}, Memory::frozen);
  const Vector3 torque(layout.rows()[0].force + 4);
  EXPECT_LT(torque.norm(), 1e-9 * Vector3(layout.rows()[0].force).norm());
}

TEST(Sweep, ContactThatOpensForgets)
{
  UnitCell cell = two_grains();
  SweepLayout layout(cell);
  layout.list_pairs(cell.neighbours, cell.box, cell.place, cell.contacts);
  layout.sweep({cell.box.h, Matrix3::Zero()}, Memory::written);
  EXPECT_EQ(layout.contacts().memories().size(), 1u);
  layout.sweep({1.01 * cell.box.h, Matrix3::Zero()}, Memory::frozen);
  EXPECT_EQ(layout.contacts().memories().size(), 1u);
  layout.sweep({1.01 * cell.box.h, Matrix3::Zero()}, Memory::written);
  EXPECT_TRUE(layout.contacts().memories().empty());
}
} // namespace
} // namespace tamp::dem
