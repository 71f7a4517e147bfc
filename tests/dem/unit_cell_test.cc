// SPDX-License-Identifier: BSD-3-Clause
#include <dem/unit_cell.h>
#include <dem/unit_cell_bytes.h>
#include <tests/dem/sample_cells.h>

#include <cstring>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace tamp::dem
{
namespace
{
using test::alumina_cell;
using test::compress;
using test::message_of;

/// A cell with all parts filled: contacts, neighbours, last motion, energies.
UnitCell lived_in()
{
  UnitCell cell = alumina_cell();
  compress(cell, -0.01, 2, {});
  return cell;
}

std::vector<char> bytes_of(const UnitCell &cell)
{
  std::vector<char> bytes;
  to_bytes(cell, bytes);
  return bytes;
}

TEST(UnitCell, CopyIsIndependent)
{
  const UnitCell original = alumina_cell();
  UnitCell copy = original;
  EXPECT_EQ(copy, original);
  compress(copy, -0.005, 1, {});
  EXPECT_NE(copy, original);
  EXPECT_EQ(original, alumina_cell());
}

TEST(UnitCell, RelativeDensityIsSolidOverBoxVolume)
{
  UnitCell cell;
  cell.box.h = 4 * Matrix3::Identity();
  cell.radius = {1, 0.5, 0.5};
  const double solid = 4.0 / 3 * std::numbers::pi * 1.25;
  EXPECT_NEAR(cell.relative_density(), solid / 64, 1e-15);
  EXPECT_EQ(cell.largest_radius(), 1);
  EXPECT_EQ(cell.smallest_radius(), 0.5);
  EXPECT_NEAR(cell.mean_radius(), 2.0 / 3, 1e-15);
}

TEST(UnitCell, ShapeAndMassAreThoseOfTheGrainsMaterials)
{
  UnitCell cell;
  cell.materials = {{70e9, 0.3, 2650, 1e9}, {210e9, 0.28, 7800, 2e9}};
  cell.species = {1, 0};
  cell.radius = {2e-4, 1e-4};
  const double unit = 4.0 / 3 * std::numbers::pi * 1e-12;
  EXPECT_NEAR(cell.mass(0), 8 * 7800 * unit, 1e-12 * cell.mass(0));
  EXPECT_NEAR(cell.mass(1), 2650 * unit, 1e-12 * cell.mass(1));
  const PairShape<double> shape = cell.shape({0, 1});
  EXPECT_DOUBLE_EQ(shape.radius_sum, 3e-4);
  EXPECT_DOUBLE_EQ(shape.reduced_radius, 2e-4 / 3);
  EXPECT_DOUBLE_EQ(shape.radius_difference, -1e-4);
  EXPECT_DOUBLE_EQ(shape.inverse_mass, 1 / cell.mass(0) + 1 / cell.mass(1));
}

TEST(UnitCellBytes, RoundTripIsEqualToTheLastBit)
{
  const UnitCell cell = lived_in();
  ASSERT_FALSE(cell.contacts.empty());
  ASSERT_FALSE(cell.neighbours.pairs.empty());
  ASSERT_FALSE(cell.last.motion.empty());
  const std::vector<char> bytes = bytes_of(cell);
  const UnitCell again = from_bytes(bytes);
  EXPECT_EQ(again.contacts, cell.contacts);
  EXPECT_EQ(again.neighbours, cell.neighbours);
  EXPECT_EQ(again, cell);
  EXPECT_EQ(bytes_of(again), bytes);
}

TEST(UnitCellBytes, DynamicStateSurvives)
{
  UnitCell cell = alumina_cell();
  Driving driving;
  driving.method = Method::dynamics;
  driving.dynamics.strain_rate = 1e-4;
  compress(cell, -1e-4, 1, driving);
  ASSERT_EQ(cell.velocity.size(), cell.size());
  EXPECT_EQ(from_bytes(bytes_of(cell)), cell);
}

TEST(UnitCellBytes, SpeciesSurviveAndAreOfMaterialsThatThereAre)
{
  UnitCell cell = lived_in();
  cell.materials.push_back({210e9, 0.28, 7800, 2e9});
  cell.species.assign(cell.size(), 0);
  cell.species[7] = 1;
  EXPECT_EQ(from_bytes(bytes_of(cell)), cell);
  EXPECT_EQ(from_bytes(bytes_of(cell)).material_of(7).density, 7800);
  cell.species[8] = 2;
  EXPECT_THROW((void)from_bytes(bytes_of(cell)), std::runtime_error);
  cell.species.assign(3, 0);
  EXPECT_THROW((void)from_bytes(bytes_of(cell)), std::runtime_error);
  cell.species.clear();
  cell.materials.clear();
  EXPECT_THROW((void)from_bytes(bytes_of(cell)), std::runtime_error);
}

TEST(UnitCellBytes, MoreMemoryThanTheLawsWantIsRefused)
{
  UnitCell cell = lived_in();
  cell.more_memory.assign(cell.contacts.size(), 0.0);
  EXPECT_THROW((void)from_bytes(bytes_of(cell)), std::runtime_error);
}

TEST(UnitCellBytes, ContinuedPathIsTheSameToTheLastBit)
{
  UnitCell here = lived_in();
  UnitCell there = from_bytes(bytes_of(here));
  const CellAnswer a = compress(here, -0.015, 3, {});
  const CellAnswer b = compress(there, -0.015, 3, {});
  EXPECT_EQ(a.stress, b.stress);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(here, there);
}

TEST(UnitCellBytes, AreAppended)
{
  std::vector<char> bytes = {'x'};
  to_bytes(alumina_cell(), bytes);
  EXPECT_EQ(bytes[0], 'x');
  EXPECT_EQ(from_bytes(std::span(bytes).subspan(1)), alumina_cell());
}

TEST(UnitCellBytes, GarbageIsRefused)
{
  std::vector<char> bytes(5000);
  for (std::size_t k = 0; k < bytes.size(); ++k)
    bytes[k] = char(k * k * 31 + k);
  EXPECT_THROW((void)from_bytes(bytes), std::runtime_error);
  EXPECT_THROW((void)from_bytes({}), std::runtime_error);
}

TEST(UnitCellBytes, GarbageBehindTheMarkIsRefused)
{
  std::vector<char> bytes = bytes_of(alumina_cell());
  for (std::size_t k = 8; k < bytes.size(); ++k)
    bytes[k] = char(k * k * 31 + k);
  EXPECT_THROW((void)from_bytes(bytes), std::runtime_error);
}

TEST(UnitCellBytes, AnyTruncationIsRefused)
{
  const std::vector<char> bytes = bytes_of(alumina_cell());
  for (std::size_t length = 0; length < bytes.size();
       length += 1 + bytes.size() / 997)
    EXPECT_THROW((void)from_bytes(std::span(bytes).first(length)),
                 std::runtime_error)
        << length;
  EXPECT_THROW((void)from_bytes(std::span(bytes).first(bytes.size() - 1)),
               std::runtime_error);
}

TEST(UnitCellBytes, MoreThanACellIsRefused)
{
  std::vector<char> bytes = bytes_of(alumina_cell());
  bytes.push_back(0);
  EXPECT_THROW((void)from_bytes(bytes), std::runtime_error);
}

TEST(UnitCellBytes, IndicesOfNoGrainAreRefused)
{
  const auto refused = [](const UnitCell &cell) {
    return !message_of<std::runtime_error>([&] {
              (void)from_bytes(bytes_of(cell));
            }).empty();
  };
  UnitCell cell = lived_in();
  cell.contacts[3].pair.second = std::uint32_t(cell.size());
  EXPECT_TRUE(refused(cell));
  cell = lived_in();
  cell.contacts[3].pair.first = cell.contacts[3].pair.second;
  EXPECT_TRUE(refused(cell));
  cell = lived_in();
  cell.neighbours.pairs.back().second = 0xffffffff;
  EXPECT_TRUE(refused(cell));
  cell = lived_in();
  cell.place.pop_back();
  EXPECT_TRUE(refused(cell));
  cell = lived_in();
  cell.last.motion.pop_back();
  EXPECT_TRUE(refused(cell));
  EXPECT_TRUE(refused(UnitCell{}));
}
} // namespace
} // namespace tamp::dem
