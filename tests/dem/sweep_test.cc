// SPDX-License-Identifier: BSD-3-Clause
#include <tests/dem/moving_cell.h>
#include <tests/dem/sample_cells.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace tamp::dem
{
namespace
{
using test::largest;
using test::largest_difference;

/// A small cell of overlapping grains, laid out and moving at random.
struct Moving : test::LaidOut<double> {
  test::SmallMotion motion;

  Moving(std::uint64_t seed,
         const ContactModel &contact,
         InstructionSet set = best_instruction_set())
      : LaidOut(with(test::random_cell(60, seed), contact), set),
        motion(test::random_motion(60, seed + 100, 2e-8, 1e-4))
  {
  }

  static UnitCell with(UnitCell cell, const ContactModel &contact)
  {
    cell.contact = contact;
    return cell;
  }

  test::Forces sweep(Memory memory) { return LaidOut::sweep(motion, memory); }
};

std::vector<ContactModel> all_models()
{
  std::vector<ContactModel> models;
  for (NormalLaw normal : {NormalLaw::hertz, NormalLaw::thornton_ning})
    for (TangentialLaw tangential :
         {TangentialLaw::none, TangentialLaw::mindlin})
      models.push_back({normal, tangential});
  return models;
}

TEST(Sweep, AgreesWithTryingAllPairsAndImages)
{
  constexpr double round_off = 1e-11; // of some ten contacts a grain
  for (const ContactModel &model : all_models())
    for (std::uint64_t seed : {1, 2, 3})
      for (Memory memory : {Memory::frozen, Memory::written}) {
        Moving moving(seed, model);
        const test::Oracle wanted = test::by_hand(moving.cell, moving.motion);
        const test::Forces found = moving.sweep(memory);
        const double size = largest(wanted.force);
        EXPECT_EQ(found.totals.contacts, wanted.totals.contacts);
        EXPECT_GT(found.totals.contacts, 40u); // there is something to compare
        EXPECT_LT(largest_difference(found.force, wanted.force),
                  round_off * size);
        EXPECT_LT(largest_difference(found.torque, wanted.torque),
                  round_off * size);
        EXPECT_NEAR(found.totals.normal_force,
                    wanted.totals.normal_force,
                    round_off * wanted.totals.normal_force);
        EXPECT_LT((found.totals.moment - wanted.totals.moment).norm(),
                  round_off * wanted.totals.moment.norm());
        if (memory == Memory::written) { // a trial does not book what is lost
          EXPECT_NEAR(found.totals.lost_work,
                      wanted.totals.lost_work,
                      round_off * wanted.totals.lost_work);
        }
        EXPECT_EQ(found.totals.too_deep, wanted.totals.too_deep);
      }
}

TEST(Sweep, ActionIsReaction)
{
  Moving moving(4, {});
  const test::Forces found = moving.sweep(Memory::frozen);
  Vector3 sum = Vector3::Zero();
  for (const Vector3 &force : found.force)
    sum += force;
  EXPECT_LT(sum.norm(), 1e-12 * largest(found.force)); // round-off
}

TEST(Sweep, FrozenMemoryIsNotTouched)
{
  Moving moving(5, {});
  const auto blocks = std::as_const(moving.layout).contacts().blocks();
  const std::vector<ContactBlock<double>> before(blocks.begin(), blocks.end());
  moving.sweep(Memory::frozen);
  EXPECT_EQ(0, std::memcmp(before.data(), blocks.data(), blocks.size_bytes()));
  moving.sweep(Memory::written);
  EXPECT_NE(0, std::memcmp(before.data(), blocks.data(), blocks.size_bytes()));
}

TEST(Sweep, FrozenTwiceIsFrozenOnce)
{
  Moving moving(6, {});
  const test::Forces once = moving.sweep(Memory::frozen);
  const test::Forces twice = moving.sweep(Memory::frozen);
  EXPECT_EQ(once.force, twice.force);
  EXPECT_EQ(once.torque, twice.torque);
  EXPECT_EQ(once.totals.moment, twice.totals.moment);
}

TEST(Sweep, WritingMemoryDoesNotChangeTheForces)
{
  Moving moving(7, {});
  const test::Forces trial = moving.sweep(Memory::frozen);
  const test::Forces written = moving.sweep(Memory::written);
  EXPECT_EQ(trial.force, written.force);
  EXPECT_EQ(trial.torque, written.torque);
  EXPECT_EQ(trial.totals.moment, written.totals.moment);
}

TEST(Sweep, WrittenStateAtRestGivesTheSameForces)
{
  Moving moving(8, {});
  const test::Forces before = moving.sweep(Memory::written);
  test::SmallMotion &motion = moving.motion;
  motion = test::no_motion(60); // the grains stay where they came
  const test::Forces after = moving.sweep(Memory::frozen);
  const double tolerance = 1e-12 * largest(before.force); // round-off of caps
  EXPECT_LT(largest_difference(before.force, after.force), tolerance);
  EXPECT_LT(largest_difference(before.torque, after.torque), tolerance);
  EXPECT_LT(after.totals.lost_work, 1e-12 * before.totals.lost_work);
}

TEST(Sweep, MomentIsZeroUnlessAskedFor)
{
  Moving moving(9, {});
  moving.move(moving.motion);
  const SweepTotals totals = moving.layout.sweep(moving.motion.affine, {});
  EXPECT_EQ(totals.moment, Matrix3::Zero());
  EXPECT_GT(moving.sweep(Memory::frozen).totals.moment.norm(), 0);
}

TEST(Sweep, TooDeepAnOverlapIsTold)
{
  UnitCell cell = test::fcc_cell(1e-3, {});
  test::LaidOut<double> laid_out(cell, best_instruction_set());
  test::SmallMotion motion = test::no_motion(cell.size());
  // Two equal grains have R* = R / 2: too deep is half their distance.
  motion.affine.stretch *= 0.51;
  EXPECT_FALSE(laid_out.sweep(motion, Memory::frozen).totals.too_deep);
  motion.affine.stretch *= 0.49 / 0.51;
  EXPECT_TRUE(laid_out.sweep(motion, Memory::frozen).totals.too_deep);
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
  cell.neighbours = {};
  Matrix3 gradient = Matrix3::Zero();
  gradient(0, 1) = 2e-4;
  for (int way : {0, 1}) {
    test::SmallMotion motion = test::no_motion(2);
    if (way == 0)
      motion.affine.stretch += gradient;
    else
      motion.relative[1] = gradient * branch;
    test::LaidOut<double> laid_out(cell, best_instruction_set());
    answers[way] = laid_out.sweep(motion, Memory::frozen).force;
  }
  EXPECT_GT(largest(answers[0]), 0);
  EXPECT_LT(largest_difference(answers[0], answers[1]),
            1e-12 * largest(answers[0]));
}

/// Two touching grains of different size in a wide box.
struct TwoGrains : testing::Test {
  test::LaidOut<double> pair = {two_grains(), best_instruction_set()};
  Vector3 branch =
      pair.cell.box.nearest_image(pair.cell.place[1] - pair.cell.place[0]);
  test::SmallMotion motion = test::no_motion(2);

  static UnitCell two_grains()
  {
    UnitCell cell;
    cell.box.h = 1e-3 * Matrix3::Identity();
    cell.radius = {1e-4, 0.7e-4};
    const Vector3 normal = Vector3(2, -1, 2) / 3;
    cell.place = {Vector3(.9, .1, .95), Vector3(.9, .1, .95) + .1699 * normal};
    return cell;
  }
};

TEST_F(TwoGrains, ConserveAngularMomentum)
{
  motion.relative[0][1] = 3e-10;
  motion.rolled[1][2] = 2e-10;
  const test::Forces found = pair.sweep(motion, Memory::frozen);
  const Vector3 first = found.torque[0], second = found.torque[1];
  EXPECT_GT(first.norm(), 0);
  // The same tangential force at both ends: torque over radius is equal.
  EXPECT_EQ(first, second);
  const Vector3 spin =
      pair.cell.radius[0] * first + pair.cell.radius[1] * second;
  const Vector3 orbit = (branch - motion.relative[0]).cross(found.force[1]);
  EXPECT_LT((spin + orbit).norm(), 1e-12 * orbit.norm());
}

TEST_F(TwoGrains, MomentIsThatOfTheWholeForceWithDampingToo)
{
  UnitCell cell = two_grains();
  cell.contact.restitution_coefficient = 0.5;
  motion.relative[1] = Vector3(-1e-9, 2e-9, 1e-9);
  const Vector3 now = branch + motion.relative[1];
  motion.affine.time = 1e-8;
  test::LaidOut<double> damped = {cell, best_instruction_set()};
  const test::Forces found = damped.sweep(motion, Memory::written);
  EXPECT_GT(
      (found.force[0] - pair.sweep(motion, Memory::written).force[0]).norm(),
      0.01 * found.force[0].norm());
  const Matrix3 wanted = found.force[1] * now.transpose();
  EXPECT_LT((found.totals.moment - wanted).norm(), 1e-12 * wanted.norm());
}

TEST_F(TwoGrains, RollingTogetherDoNotSlip)
{
  // Both grains and the pair turn as one rigid body.
  const Vector3 turn(1e-5, 2e-5, -3e-5);
  Matrix3 half;
  half << 0, -turn.z(), turn.y(), turn.z(), 0, -turn.x(), -turn.y(), turn.x(),
      0;
  half *= 0.5;
  const Matrix3 rotation =
      (Matrix3::Identity() - half).inverse() * (Matrix3::Identity() + half);
  motion.relative[1] = rotation * branch - branch;
  for (int i : {0, 1})
    motion.rolled[i] = pair.cell.radius[i] * turn;
  const test::Forces found = pair.sweep(motion, Memory::frozen);
  EXPECT_GT(found.force[0].norm(), 0);
  EXPECT_LT(found.torque[0].norm(), 1e-9 * found.force[0].norm());
}

TEST_F(TwoGrains, ForgetTheContactWhenItOpens)
{
  pair.sweep(motion, Memory::written);
  EXPECT_EQ(pair.memories().size(), 1u);
  motion.affine.stretch *= 1.01;
  pair.sweep(motion, Memory::frozen);
  EXPECT_EQ(pair.memories().size(), 1u);
  pair.sweep(motion, Memory::written);
  EXPECT_TRUE(pair.memories().empty());
}
} // namespace
} // namespace tamp::dem
