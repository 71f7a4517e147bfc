// SPDX-License-Identifier: BSD-3-Clause
#include <tests/dem/moving_cell.h>
#include <tests/dem/sample_cells.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

// Sweeps of unusual cells: two materials, few contacts, resistance to rolling.
namespace tamp::dem
{
namespace
{
using test::largest;
using test::largest_difference;

constexpr double motion_size = 2e-8; // of grains of 100 um [m]

template <class T>
void expect_as_by_hand(const test::LaidOut<T> &start,
                       const test::SmallMotion &motion,
                       double tolerance)
{
  test::LaidOut<T> laid_out = start;
  const test::Oracle wanted = test::by_hand(laid_out.cell, motion);
  const test::Forces found = laid_out.sweep(motion, Memory::written);
  const double size = largest(wanted.force);
  EXPECT_EQ(found.totals.contacts, wanted.totals.contacts);
  EXPECT_LE(largest_difference(found.force, wanted.force), tolerance * size);
  EXPECT_LE(largest_difference(found.torque, wanted.torque), tolerance * size);
  EXPECT_NEAR(found.totals.normal_force,
              wanted.totals.normal_force,
              tolerance * wanted.totals.normal_force);
  EXPECT_LE((found.totals.moment - wanted.totals.moment).norm(),
            tolerance * wanted.totals.moment.norm());
  EXPECT_NEAR(found.totals.lost_work,
              wanted.totals.lost_work,
              tolerance * wanted.totals.normal_force * motion_size);
  const std::vector<ContactMemory> memories = laid_out.memories();
  ASSERT_EQ(memories.size(), wanted.memories.size());
  for (std::size_t c = 0; c < memories.size(); ++c) {
    const ContactMemory &a = memories[c], &b = wanted.memories[c];
    ASSERT_EQ(a.pair, b.pair); // by hand they come sorted
    EXPECT_LE((a.tangential_force - b.tangential_force).norm(),
              tolerance * size);
    EXPECT_NEAR(a.largest_overlap, b.largest_overlap, tolerance * 1e-4);
    EXPECT_NEAR(a.contact_radius, b.contact_radius, tolerance * 1e-4);
  }
}

TEST(TwoSpecies, SweepAgreesWithTryingAllPairsAndImages)
{
  constexpr double round_off = 1e-11; // of some ten contacts a grain
  for (NormalLaw normal : {NormalLaw::hertz, NormalLaw::thornton_ning})
    for (TangentialLaw tangential :
         {TangentialLaw::none, TangentialLaw::mindlin})
      for (InstructionSet set : instruction_sets()) {
        SCOPED_TRACE(name_of(set));
        UnitCell cell = test::random_cell(60, 11);
        cell.contact = {normal, tangential};
        test::mix_species(cell);
        const test::LaidOut<double> laid_out(cell, set);
        const auto groups = laid_out.layout.contacts().groups();
        ASSERT_EQ(groups.size(), 3u);
        for (const auto &group : groups)
          ASSERT_GT(group.size, 10u); // pairs of every kind
        expect_as_by_hand(laid_out,
                          test::random_motion(60, 12, motion_size, 1e-4),
                          round_off);
      }
}

TEST(TwoSpecies, LawsOwnNumbersComeBackWithTheirContacts)
{
  // Of a cell whose grains rest, every number is as it was.
  UnitCell start = test::random_cell(60, 13);
  test::mix_species(start);
  const UnitCell cell =
      test::with_history(start,
                         {.tangential_law = TangentialLaw::mindlin_deresiewicz,
                          .rolling_law = RollingLaw::epsd},
                         motion_size);
  const test::LaidOut<double> laid_out(cell, best_instruction_set());
  ASSERT_EQ(laid_out.layout.contacts().groups().size(), 3u);
  const UnitCell again = laid_out.remembering();
  EXPECT_EQ(again.contacts, cell.contacts);
  EXPECT_EQ(again.more_memory, cell.more_memory);
  EXPECT_TRUE(std::ranges::is_sorted(
      again.contacts, {}, [](const ContactMemory &m) { return m.pair; }));
  EXPECT_TRUE(std::ranges::any_of(again.more_memory,
                                  [](double value) { return value != 0; }));
}

TEST(TwoSpecies, AlikeAreOne)
{
  // The same material twice is three kinds of pairs with the same laws.
  const UnitCell one = test::random_cell(60, 14);
  UnitCell two = one;
  test::mix_species(two);
  two.materials[1] = two.materials[0] = one.materials[0];
  const test::SmallMotion motion =
      test::random_motion(60, 15, motion_size, 1e-4);
  test::LaidOut<double> of_one(one, best_instruction_set());
  test::LaidOut<double> of_two(two, best_instruction_set());
  const test::Forces wanted = of_one.sweep(motion, Memory::written);
  const test::Forces found = of_two.sweep(motion, Memory::written);
  EXPECT_LT(largest_difference(found.force, wanted.force),
            1e-13 * largest(wanted.force)); // another order of sums
  EXPECT_EQ(of_two.memories(), of_one.memories());
}

/// A wavy chain of grains in a wide box, `pairs` of which overlap.
UnitCell chain(std::size_t pairs)
{
  UnitCell cell;
  const std::size_t grains = std::max<std::size_t>(pairs + 1, 2);
  const double apart = pairs == 0 ? 3e-4 : 1.98e-4;
  const double edge = 1e-3 + double(grains) * apart;
  cell.box.h = edge * Matrix3::Identity();
  cell.reference_volume = cell.box.volume();
  for (std::size_t k = 0; k < grains; ++k) {
    cell.radius.push_back(1e-4);
    cell.place.emplace_back(double(k) * apart / edge,
                            2e-6 * std::sin(double(k)) / edge,
                            0.5 + 2e-6 * std::cos(2.0 * double(k)) / edge);
  }
  return cell;
}

TEST(FewContacts, AreComputedOnceAndPaddingNever)
{
  for (std::size_t pairs : {0, 1, 15, 16, 17, 63, 64, 65}) {
    const UnitCell cell = chain(pairs);
    const test::SmallMotion motion =
        test::random_motion(cell.size(), 16, motion_size, 1e-4);
    for (InstructionSet set : instruction_sets()) {
      SCOPED_TRACE(name_of(set) + " " + std::to_string(pairs));
      const test::LaidOut<double> in_double(cell, set);
      ASSERT_EQ(in_double.layout.contacts().size(), pairs);
      expect_as_by_hand(in_double, motion, 1e-11); // round-off
      // Overlaps of a hundredth of a radius in single precision.
      const test::LaidOut<float> in_float(cell, set);
      expect_as_by_hand(in_float, motion, 1e-5);
    }
  }
}

TEST(FewContacts, PaddingDoesNothingInAnyLaw)
{
  for (const ContactModel &model : test::every_contact_model())
    for (std::size_t pairs : {0, 1, 17}) {
      const UnitCell cell =
          test::with_history(chain(pairs), model, motion_size);
      test::SmallMotion motion =
          test::random_motion(cell.size(), 17, motion_size, 1e-4);
      motion.affine.time = 1e-7;
      for (InstructionSet set : instruction_sets()) {
        test::LaidOut<double> laid_out(cell, set);
        const test::Forces found = laid_out.sweep(motion, Memory::written);
        EXPECT_EQ(found.totals.contacts, pairs);
        EXPECT_EQ(laid_out.memories().size(), pairs);
        EXPECT_EQ(found.totals.normal_force > 0, pairs > 0);
        Vector3 sum = Vector3::Zero();
        for (const Vector3 &force : found.force)
          sum += force;
        EXPECT_LE(sum.norm(), 1e-12 * largest(found.force)); // round-off
      }
    }
}

/// Two touching grains of different size and no friction that resist rolling.
struct RollingGrains : testing::Test {
  static constexpr double mu_r = 0.2;
  UnitCell cell = two_grains();
  Vector3 normal = Vector3(2, -1, 2) / 3,
          around = Vector3(1, 2, 0).normalized();
  test::SmallMotion motion = test::no_motion(2);

  static UnitCell two_grains()
  {
    UnitCell cell;
    cell.contact = {.normal_law = NormalLaw::hertz,
                    .tangential_law = TangentialLaw::none,
                    .rolling_law = RollingLaw::epsd,
                    .friction_coefficient = 0,
                    .rolling_friction_coefficient = mu_r};
    cell.box.h = 1e-3 * Matrix3::Identity();
    cell.radius = {1e-4, 0.7e-4};
    const Vector3 normal = Vector3(2, -1, 2) / 3;
    cell.place = {Vector3(.9, .1, .95), Vector3(.9, .1, .95) + .1699 * normal};
    return cell;
  }
  /// Moments on the two grains [N m].
  std::vector<Vector3> moments(InstructionSet set)
  {
    test::LaidOut<double> laid_out(cell, set);
    const test::Forces found = laid_out.sweep(motion, Memory::frozen);
    return {cell.radius[0] * found.torque[0], cell.radius[1] * found.torque[1]};
  }
  /// k_r = 2.25 * 2 E* a (mu_r R*)^2 [N m/rad] and mu_r R* N [N m].
  struct ByHand {
    double stiffness, most;
  };
  ByHand by_hand() const
  {
    const double overlap = 0.1e-6, reduced = 1e-4 * 0.7e-4 / 1.7e-4;
    const double modulus = 70e9 / (2 * (1 - 0.3 * 0.3));
    const double a = std::sqrt(reduced * overlap), arm = mu_r * reduced;
    const double force = 4.0 / 3 * modulus * a * overlap;
    return {4.5 * modulus * a * arm * arm, arm * force};
  }
};

TEST_F(RollingGrains, MomentIsThatOfASpringWithALimit)
{
  const auto [stiffness, most] = by_hand();
  const double limit = most / stiffness; // [rad]
  for (InstructionSet set : instruction_sets())
    for (double share : {-0.5, 0.3, 2.0}) {
      // A part of the rotation each, in opposite directions.
      const double turn = share * limit;
      motion.rolled[0] = 0.4 * turn * cell.radius[0] * around;
      motion.rolled[1] = -0.6 * turn * cell.radius[1] * around;
      const double size = std::min(std::abs(share), 1.0) * most;
      const Vector3 wanted = (share > 0 ? -size : size) * around;
      // The overlap of 1e-7 is a difference of lengths of 1e-4.
      EXPECT_LT((moments(set)[0] - wanted).norm(), 1e-9 * most);
    }
}

TEST_F(RollingGrains, MomentOnOneIsOppositeToMomentOnOther)
{
  cell.contact.tangential_law = TangentialLaw::mindlin;
  cell.contact.friction_coefficient = 0.3;
  motion = test::random_motion(2, 19, 1e-10, 1);
  motion.affine = {};
  const Vector3 branch = cell.box.nearest_image(cell.place[1] - cell.place[0]) +
                         motion.relative[1] - motion.relative[0];
  for (InstructionSet set : instruction_sets()) {
    test::LaidOut<double> laid_out(cell, set);
    const test::Forces found = laid_out.sweep(motion, Memory::frozen);
    const Vector3 spin =
        cell.radius[0] * found.torque[0] + cell.radius[1] * found.torque[1];
    const Vector3 orbit = branch.cross(found.force[1]);
    EXPECT_GT(orbit.norm(), 0);
    EXPECT_LT((spin + orbit).norm(), 1e-12 * orbit.norm()); // round-off
    // Without rolling resistance both torques over radius would be equal.
    EXPECT_GT((found.torque[0] - found.torque[1]).norm(),
              0.01 * found.torque[0].norm());
  }
}

TEST_F(RollingGrains, RigidTurnMakesNoMoment)
{
  for (int i : {0, 1})
    motion.rolled[i] = 1e-5 * cell.radius[i] * around;
  for (InstructionSet set : instruction_sets())
    for (const Vector3 &moment : moments(set))
      EXPECT_LT(moment.norm(), 1e-12 * by_hand().most); // round-off
}
} // namespace
} // namespace tamp::dem
