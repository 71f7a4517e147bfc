// SPDX-License-Identifier: BSD-3-Clause
#include <dem/unit_cell.h>
#include <dem/unit_cell_bytes.h>
#include <tests/dem/sample_cells.h>

#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

// Bytes of cells of every law, and of what is no cell.
namespace tamp::dem
{
namespace
{
std::vector<char> bytes_of(const UnitCell &cell)
{
  std::vector<char> bytes;
  to_bytes(cell, bytes);
  return bytes;
}

/// Compressed and sheared, so that every law has something to remember.
CellAnswer press(UnitCell &cell)
{
  Stretch stretch = test::uniaxial(-1e-3);
  stretch(0, 2) = stretch(2, 0) = 5e-4;
  Driving driving;
  driving.quasi_static.maximum_evaluations = 40; // settled or not
  return deform(cell, stretch, driving);
}

TEST(UnitCellBytes, EveryLawAndTwoSpeciesReplayToTheLastBit)
{
  for (const ContactModel &model : test::every_contact_model()) {
    SCOPED_TRACE(int(model.normal_law) * 100 + int(model.tangential_law) * 10 +
                 int(model.rolling_law));
    UnitCell cell = test::fcc_cell(1e-3, model);
    test::mix_species(cell);
    cell.contacts.clear(); // they were those of one species
    cell.more_memory.clear();
    ASSERT_NE(press(cell).outcome, Outcome::diverged);
    ASSERT_FALSE(cell.contacts.empty());
    const std::vector<char> bytes = bytes_of(cell);
    UnitCell copy = cell, again = from_bytes(bytes);
    EXPECT_EQ(again, cell);
    EXPECT_EQ(bytes_of(again), bytes);
    const CellAnswer one = press(cell), other = press(copy);
    const CellAnswer third = press(again);
    EXPECT_GT(one.stress.norm(), 0);
    EXPECT_EQ(one.stress, other.stress);
    EXPECT_EQ(one.stress, third.stress);
    EXPECT_EQ(copy, cell);
    EXPECT_EQ(again, cell);
    EXPECT_EQ(bytes_of(copy), bytes_of(cell));
    EXPECT_EQ(bytes_of(again), bytes_of(cell));
  }
}

TEST(UnitCellBytes, AdjustedPressuresReplayToTheLastBit)
{
  UnitCell cell =
      test::fcc_cell(1e-3, {.normal_law = NormalLaw::thornton_ning_adjusted});
  test::mix_species(cell);
  cell.contacts.clear(); // they were those of one species
  cell.more_memory.clear();
  cell.materials[1].adjusted_pressures = {{0.72, 2e7}, {0.75, 4e8}};
  for (int k = 0; k < 3; ++k) {
    UnitCell again = from_bytes(bytes_of(cell));
    ASSERT_EQ(again, cell);
    EXPECT_EQ(press(again).stress, press(cell).stress);
    EXPECT_EQ(bytes_of(again), bytes_of(cell));
  }
}

TEST(UnitCellBytes, EqualCellsGiveEqualBytesWhateverLiesBetweenTheirMembers)
{
  const ContactModel model;
  std::vector<char> bytes[2];
  for (int k : {0, 1}) {
    UnitCell cell = test::fcc_cell(1e-3, model);
    ContactModel &own = cell.contact;
    std::memset(static_cast<void *>(&own), k == 0 ? 0x00 : 0xab, sizeof(own));
    own.normal_law = model.normal_law;
    own.tangential_law = model.tangential_law;
    own.rolling_law = model.rolling_law;
    own.friction_coefficient = model.friction_coefficient;
    own.work_of_adhesion = model.work_of_adhesion;
    own.rolling_friction_coefficient = model.rolling_friction_coefficient;
    own.restitution_coefficient = model.restitution_coefficient;
    own.bulk_onset = model.bulk_onset;
    ASSERT_EQ(own, model);
    to_bytes(cell, bytes[k]);
  }
  EXPECT_EQ(bytes[0], bytes[1]);
}

/// A change makes bytes that are refused.
template <class Change>
void expect_refused(const Change &change)
{
  UnitCell cell = test::fcc_cell(1e-3, {});
  press(cell); // lists its neighbours
  EXPECT_NO_THROW((void)from_bytes(bytes_of(cell)));
  change(cell);
  EXPECT_THROW((void)from_bytes(bytes_of(cell)), std::runtime_error);
}

TEST(UnitCellBytes, LawsThatThereAreNotAreRefused)
{
  expect_refused(
      [](UnitCell &cell) { cell.contact.normal_law = NormalLaw(7); });
  expect_refused(
      [](UnitCell &cell) { cell.contact.normal_law = NormalLaw(-1); });
  expect_refused(
      [](UnitCell &cell) { cell.contact.tangential_law = TangentialLaw(3); });
  expect_refused(
      [](UnitCell &cell) { cell.contact.rolling_law = RollingLaw(2); });
}

TEST(UnitCellBytes, SizesThatAreNoneAreRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (double size : {nan, 0.0, -1e-4, infinity})
    expect_refused([&](UnitCell &cell) { cell.radius[5] = size; });
  expect_refused([&](UnitCell &cell) { cell.box.h(1, 1) = nan; });
  expect_refused([&](UnitCell &cell) { cell.box.h(1, 1) = -cell.box.h(1, 1); });
  expect_refused([&](UnitCell &cell) { cell.place[3][2] = nan; });
}

TEST(UnitCellBytes, UnphysicalConstantsAreRefused)
{
  expect_refused([](UnitCell &cell) { cell.materials[0].youngs_modulus = 0; });
  expect_refused([](UnitCell &cell) { // the law takes it for constant
    cell.materials[0].adjusted_pressures = {{0.6, 1e8}};
  });
  expect_refused(
      [](UnitCell &cell) { cell.contact.friction_coefficient = -1; });
  expect_refused(
      [](UnitCell &cell) { cell.contact.restitution_coefficient = 1.1; });
}

TEST(UnitCellBytes, PairsOutOfOrderOrTwiceAreRefused)
{
  expect_refused(
      [](UnitCell &cell) { std::swap(cell.contacts[3], cell.contacts[4]); });
  expect_refused(
      [](UnitCell &cell) { cell.contacts[4].pair = cell.contacts[3].pair; });
  expect_refused([](UnitCell &cell) {
    std::swap(cell.neighbours.pairs[3], cell.neighbours.pairs[4]);
  });
}
} // namespace
} // namespace tamp::dem
