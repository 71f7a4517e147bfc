// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <tests/dem/moving_cell.h>
#include <tests/dem/sample_cells.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <variant>
#include <vector>

// Every instruction set and both precisions give what scalar numbers in double
// precision give.
namespace tamp::dem
{
namespace
{
using test::largest;
using test::largest_difference;

constexpr double motion_size = 2e-8; // of grains of 100 um [m]

std::string name_of(const ContactModel &model, InstructionSet set)
{
  const auto number = [](auto law) { return std::to_string(int(law)); };
  return name_of(set) + " normal law " + number(model.normal_law) +
         " tangential law " + number(model.tangential_law) + " rolling law " +
         number(model.rolling_law);
}

/// What a sweep leaves behind.
struct Result {
  test::Forces forces;
  UnitCell cell; // with the memories
};

Result sweep_of(const UnitCell &cell, InstructionSet set, double time)
{
  test::LaidOut<double> laid_out(cell, set);
  test::SmallMotion motion =
      test::random_motion(cell.size(), 7, motion_size, 1e-4);
  motion.affine.time = time;
  Result result;
  result.forces = laid_out.sweep(motion, Memory::written);
  result.cell = laid_out.remembering();
  return result;
}

/// The largest of every law's own number over the contacts.
std::vector<double> largest_more(const UnitCell &cell)
{
  const std::size_t rows = CellLaws(cell).more();
  std::vector<double> result(rows, 0.0);
  for (std::size_t k = 0; k < cell.more_memory.size(); ++k)
    result[k % rows] =
        std::max(result[k % rows], std::abs(cell.more_memory[k]));
  return result;
}

void expect_same_memories(const UnitCell &found,
                          const UnitCell &wanted,
                          double force,
                          double tolerance)
{
  ASSERT_EQ(found.contacts.size(), wanted.contacts.size());
  constexpr double length = 1e-4; // of overlaps and contact radii [m]
  for (std::size_t c = 0; c < found.contacts.size(); ++c) {
    const ContactMemory &a = found.contacts[c], &b = wanted.contacts[c];
    ASSERT_EQ(a.pair, b.pair);
    EXPECT_LT((a.tangential_force - b.tangential_force).norm(),
              tolerance * force);
    EXPECT_NEAR(a.largest_overlap, b.largest_overlap, tolerance * length);
    EXPECT_NEAR(a.contact_radius, b.contact_radius, tolerance * length);
  }
  ASSERT_EQ(found.more_memory.size(), wanted.more_memory.size());
  const std::vector<double> scale = largest_more(wanted);
  for (std::size_t k = 0; k < found.more_memory.size(); ++k)
    EXPECT_NEAR(found.more_memory[k],
                wanted.more_memory[k],
                tolerance * scale[k % scale.size()])
        << k % scale.size();
}

void expect_same(const Result &found, const Result &wanted, double tolerance)
{
  const double force = largest(wanted.forces.force);
  EXPECT_LT(largest_difference(found.forces.force, wanted.forces.force),
            tolerance * force);
  EXPECT_LT(largest_difference(found.forces.torque, wanted.forces.torque),
            tolerance * force);
  const SweepTotals &a = found.forces.totals, &b = wanted.forces.totals;
  EXPECT_EQ(a.contacts, b.contacts);
  EXPECT_EQ(a.too_deep, b.too_deep);
  EXPECT_NEAR(a.normal_force, b.normal_force, tolerance * b.normal_force);
  EXPECT_LT((a.moment - b.moment).norm(), tolerance * b.moment.norm());
  // Differences of energies and of works of forces over the motion.
  const double work = b.normal_force * motion_size;
  EXPECT_NEAR(a.lost_work, b.lost_work, tolerance * work);
  EXPECT_NEAR(a.damped_work, b.damped_work, tolerance * work);
  EXPECT_NEAR(a.adhesion_loss, b.adhesion_loss, tolerance * work);
  EXPECT_NEAR(a.forgotten_loss, b.forgotten_loss, tolerance * work);
  expect_same_memories(found.cell, wanted.cell, force, tolerance);
}

TEST(InstructionSets, AgreeWithScalarForEveryLaw)
{
  constexpr double round_off = 1e-12; // of sums of ten contacts a grain
  constexpr double time = 1e-7;       // as long as an impact of such grains [s]
  const UnitCell start = test::random_cell(60, 3);
  for (const ContactModel &model : test::every_contact_model()) {
    const UnitCell cell = test::with_history(start, model, motion_size);
    ASSERT_GT(cell.contacts.size(), 40u); // there is something to compare
    for (double since : {0.0, time}) {
      const Result wanted = sweep_of(cell, InstructionSet::scalar, since);
      EXPECT_EQ(wanted.forces.totals.damped_work > 0, since > 0);
      EXPECT_EQ(wanted.forces.totals.lost_work > 0,
                model.tangential_law != TangentialLaw::none ||
                    model.rolling_law != RollingLaw::none);
      for (InstructionSet set : instruction_sets()) {
        SCOPED_TRACE(name_of(model, set) + (since > 0 ? " damped" : ""));
        expect_same(sweep_of(cell, set, since), wanted, round_off);
      }
    }
  }
}

TEST(InstructionSets, TrialsAgreeWithWrittenSweepsForEveryLaw)
{
  const UnitCell start = test::random_cell(60, 4);
  const test::SmallMotion motion =
      test::random_motion(start.size(), 8, motion_size, 1e-4);
  for (const ContactModel &model : test::every_contact_model()) {
    const UnitCell cell = test::with_history(start, model, motion_size);
    for (InstructionSet set : instruction_sets()) {
      SCOPED_TRACE(name_of(model, set));
      test::LaidOut<double> laid_out(cell, set);
      const test::Forces trial = laid_out.sweep(motion, Memory::frozen);
      const test::Forces written = laid_out.sweep(motion, Memory::written);
      EXPECT_EQ(trial.force, written.force);
      EXPECT_EQ(trial.torque, written.torque);
    }
  }
}

/// Of the contacts of a cell [N].
double largest_normal_force(const UnitCell &cell)
{
  const CellLaws laws(cell);
  double result = 0;
  for (const ContactMemory &contact : cell.contacts) {
    const auto [i, j] = contact.pair;
    const double distance =
        cell.box.nearest_image(cell.place[j] - cell.place[i]).norm();
    NormalMemory<double> memory = {contact.largest_overlap,
                                   contact.contact_radius};
    const PairShape<double> shape = cell.shape(contact.pair);
    std::visit(
        [&](const auto &law) {
          result = std::max(
              result, law(shape.radius_sum - distance, shape, memory).force);
        },
        laws.of(contact.pair).normal);
  }
  return result;
}

TEST(MixedPrecision, ForcesAreThoseOfDoubleInAJammedCell)
{
  // Single precision has 6e-8; a grain has some six contacts, which nearly
  // balance, and each force goes with the power 3/2 of its overlap.
  constexpr double tolerance = 1e-6;
  const UnitCell &cell = test::alumina_cell();
  const test::SmallMotion motion =
      test::random_motion(cell.size(), 9, 1e-4 * cell.mean_radius(), 1);
  for (InstructionSet set : instruction_sets()) {
    test::LaidOut<double> in_double(cell, set);
    test::LaidOut<float> in_float(cell, set);
    const test::Forces wanted = in_double.sweep(motion, Memory::frozen);
    const test::Forces found = in_float.sweep(motion, Memory::frozen);
    const double scale = largest_normal_force(cell);
    EXPECT_GT(wanted.totals.contacts, cell.size());
    EXPECT_EQ(found.totals.contacts, wanted.totals.contacts);
    EXPECT_LT(largest_difference(found.force, wanted.force), tolerance * scale);
    EXPECT_LT(largest_difference(found.torque, wanted.torque),
              tolerance * scale);
    EXPECT_LT((found.totals.moment - wanted.totals.moment).norm(),
              tolerance * wanted.totals.moment.norm());
  }
}

Matrix3 stress_after_five_thousandths(const Arithmetic &arithmetic)
{
  UnitCell cell = test::alumina_cell();
  Driving driving;
  driving.arithmetic = arithmetic;
  const CellAnswer answer = test::compress(cell, -5e-3, 5, driving);
  EXPECT_EQ(answer.outcome, Outcome::settled);
  return answer.stress;
}

TEST(InstructionSets, DeformReachesTheSameStress)
{
  // The map ends within its unbalance of equilibrium, wherever round-off leads
  // it; single precision ends a little farther off.
  constexpr double among_sets = 1e-3, mixed = 1e-2;
  const Matrix3 wanted = stress_after_five_thousandths(
      {Precision::double_precision, InstructionSet::scalar});
  ASSERT_GT(wanted.norm(), 0.9e6); // more than 0.5 MPa on all sides has
  for (InstructionSet set : instruction_sets()) {
    SCOPED_TRACE(dem::name_of(set));
    const Matrix3 in_double =
        stress_after_five_thousandths({Precision::double_precision, set});
    EXPECT_LT((in_double - wanted).norm(), among_sets * wanted.norm());
    const Matrix3 in_float =
        stress_after_five_thousandths({Precision::mixed, set});
    EXPECT_LT((in_float - wanted).norm(), mixed * wanted.norm());
  }
}

TEST(InstructionSets, SlowMotionIsNotLostInSinglePrecision)
{
  // Steps of 2e-8 of strain are below the last place of a branch in single
  // precision: without new branches from the places 7 % of the rise are lost.
  const auto rise = [](Precision precision) {
    UnitCell cell = test::alumina_cell();
    const double before = love_weber_stress(cell)(1, 1);
    Driving driving;
    driving.method = Method::dynamics;
    driving.arithmetic.precision = precision;
    driving.dynamics.strain_rate = 1e-7;
    UnitCell trial = cell;
    const auto steps = test::compress(trial, -2e-5, 1, driving).evaluations;
    driving.dynamics.strain_rate *= 2e-8 * double(steps) / 2e-5;
    const CellAnswer answer = test::compress(cell, -1e-3, 1, driving);
    EXPECT_GT(answer.evaluations, 40000u);
    return love_weber_stress(cell)(1, 1) - before;
  };
  EXPECT_NEAR(
      rise(Precision::mixed) / rise(Precision::double_precision), 1, 2e-3);
}
} // namespace
} // namespace tamp::dem
