// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/density_table.h>
#include <fem/laws/mcc_ph102.h>

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
const TableRows rows{{0.3, 0.5, 0.9}, {1., 2., 10.}};

TEST(DensityTable, JoinsRowsByLines)
{
  const DensityTable table(rows, "test");
  EXPECT_DOUBLE_EQ(table.read(0.3).value, 1);
  EXPECT_DOUBLE_EQ(table.read(0.4).value, 1.5);
  EXPECT_DOUBLE_EQ(table.read(0.4).slope, 5);
  EXPECT_DOUBLE_EQ(table.read(0.7).value, 6);
  EXPECT_DOUBLE_EQ(table.read(0.9).value, 10);
  EXPECT_FALSE(table.read(0.9).outside);
}

TEST(DensityTable, SaysWhenItIsLeft)
{
  const DensityTable held(rows, "test");
  EXPECT_TRUE(held.read(0.29).outside);
  EXPECT_DOUBLE_EQ(held.read(0.29).value, 1);
  EXPECT_DOUBLE_EQ(held.read(0.29).slope, 0);
  EXPECT_TRUE(held.read(0.95).outside);
  EXPECT_DOUBLE_EQ(held.read(0.95).value, 10);

  const DensityTable extended(rows,
                              "test",
                              DensityTable::Shape::increasing,
                              DensityTable::Above::extend);
  EXPECT_TRUE(extended.read(0.95).outside);
  EXPECT_DOUBLE_EQ(extended.read(0.95).value, 11);
}

TEST(DensityTable, ConstantHoldsEverywhere)
{
  const DensityTable constant(3.);
  EXPECT_DOUBLE_EQ(constant.read(-5).value, 3);
  EXPECT_DOUBLE_EQ(constant.read(7).slope, 0);
  EXPECT_FALSE(constant.read(7).outside);
}

TEST(DensityTable, LineSaysWhatReadingSays)
{
  const DensityTable held(rows, "test");
  const DensityTable extended(rows,
                              "test",
                              DensityTable::Shape::increasing,
                              DensityTable::Above::extend);
  for (const auto *table : {&held, &extended})
    for (double x = 0.2; x < 1.1; x += 0.01) {
      const auto line = table->line(x);
      EXPECT_TRUE(line.holds(x)) << x;
      EXPECT_EQ(line.at(x), table->read(x).value) << x;
      EXPECT_EQ(line.slope, table->read(x).slope) << x;
    }
}

TEST(DensityTable, RefusesRowsThatMakeNoTable)
{
  const auto build = [](const TableRows &rows) {
    return DensityTable(rows, "test", DensityTable::Shape::increasing);
  };
  EXPECT_THROW(build({{0.3}, {1}}), std::invalid_argument);
  EXPECT_THROW(build({{0.3, 0.4}, {1}}), std::invalid_argument);
  EXPECT_THROW(build({{0.3, 0.3}, {1, 2}}), std::invalid_argument);
  EXPECT_THROW(build({{0.3, 0.4}, {2, 1}}), std::invalid_argument);
  EXPECT_THROW(build({{0.3, 0.4}, {1, NAN}}), std::invalid_argument);
  EXPECT_NO_THROW(build({{0.3, 0.4}, {1, 1}}));
}

TEST(MccPh102, RowsAreThoseOfTheSource)
{
  EXPECT_DOUBLE_EQ(mcc_ph102::youngs_modulus().read(0.803).value, 3715e6);
  EXPECT_DOUBLE_EQ(mcc_ph102::poissons_ratio().read(0.98).value, 0.309);
  EXPECT_DOUBLE_EQ(mcc_ph102::cohesion().read(0.93).value, 29.98e6);
  EXPECT_NEAR(
      mcc_ph102::friction_angle().read(0.7).value, 68.07 * M_PI / 180, 1e-14);
  EXPECT_DOUBLE_EQ(mcc_ph102::eccentricity().read(0.99).value, 1.608);
  // p_b at 0.8 belongs to ln(0.8 / 0.3).
  EXPECT_NEAR(
      mcc_ph102::hardening().read(std::log(0.8 / 0.3)).value, 64.7e6, 1e-3);
}
} // namespace
} // namespace tamp::fem
