// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <dem/servo.h>
#include <tests/dem/sample_cells.h>

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
double pressure(const UnitCell &cell)
{
  return -measure(cell).stress.trace() / 3;
}

Dynamics slow()
{
  Dynamics settings;
  settings.strain_rate = 2e-4;
  return settings;
}

TEST(Servo, ReachesThePressureUpAndDownAtRest)
{
  UnitCell cell = test::alumina_cell();
  for (double wanted : {1e6, 0.7e6}) {
    const CellAnswer answer =
        servo_to_pressure(cell, {.pressure = wanted}, slow());
    EXPECT_EQ(answer.outcome, Outcome::settled);
    EXPECT_NEAR(pressure(cell), wanted, 0.01 * wanted);
    EXPECT_LE(answer.unbalance, 5e-3);
  }
}

TEST(Servo, CompressesAsTheQuasiStaticMapDoes)
{
  UnitCell moved = test::alumina_cell(), mapped = test::alumina_cell();
  ASSERT_EQ(servo_to_pressure(moved, {.pressure = 1.5e6}, slow()).outcome,
            Outcome::settled);
  // The same volume by the map: the same pressure within 1 % of the servo, 1 %
  // of rearrangements.
  const double strain = std::log(moved.box.volume() / mapped.box.volume()) / 3;
  constexpr int steps = 10;
  CellAnswer answer;
  for (int k = 0; k < steps; ++k)
    answer = deform(mapped, std::exp(strain / steps) * Stretch::Identity(), {});
  EXPECT_NEAR(-answer.stress.trace() / 3, pressure(moved), 0.03e6);
}

TEST(Servo, GivesUpAfterTheStepsAllowed)
{
  UnitCell cell = test::alumina_cell();
  const CellAnswer answer =
      servo_to_pressure(cell, {.pressure = 5e6, .most_steps = 100}, slow());
  EXPECT_EQ(answer.outcome, Outcome::unsettled);
  EXPECT_LT(answer.evaluations, 1000u);
}

TEST(Servo, PressureMustBePositive)
{
  UnitCell cell = test::alumina_cell();
  EXPECT_THROW(servo_to_pressure(cell, {.pressure = 0}, slow()),
               std::invalid_argument);
}
} // namespace
} // namespace tamp::dem
