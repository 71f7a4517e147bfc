// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <dem/remarks.h>
#include <dem/unit_cell_bytes.h>
#include <tests/dem/mdr_cells.h>
#include <tests/dem/sample_cells.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

// What cells with grains that grow are as values: copies, bytes, lists.
namespace tamp::dem
{
namespace
{
using test::grown_cell;
using test::mdr_cell;
using test::message_of;
using test::request_for;
using test::take_to;

TEST(MdrCell, MassAndDensityAreThoseOfTheInitialSizes)
{
  const UnitCell &cell = grown_cell();
  ASSERT_EQ(cell.initial_radius.size(), cell.size());
  for (std::size_t g = 0; g < cell.size(); ++g)
    EXPECT_EQ(cell.initial_radius[g], mdr_cell().initial_radius_of(g));
  EXPECT_EQ(cell.solid_volume(), mdr_cell().solid_volume());
  EXPECT_EQ(cell.mass(3), mdr_cell().mass(3));
  EXPECT_NEAR(cell.relative_density(), 0.9, 1e-12);
  double growth = 0;
  for (std::size_t g = 0; g < cell.size(); ++g)
    growth += cell.radius[g] / cell.initial_radius[g] - 1;
  EXPECT_GT(growth / double(cell.size()), 0.01);
}

TEST(MdrCell, TrialsLeaveNoTrace)
{
  const UnitCell committed = grown_cell();
  UnitCell trial = committed;
  WarmGuess guess;
  const Stretch stretch = 0.998 * Matrix3::Identity();
  const CellAnswer one = deform(trial, stretch, {}, &guess);
  EXPECT_EQ(committed, grown_cell());
  UnitCell again = committed;
  const CellAnswer two = deform(again, stretch, {});
  EXPECT_EQ(one.stress, two.stress);
  EXPECT_EQ(trial, again);
  EXPECT_NE(trial.radius, committed.radius);
  UnitCell warm = committed; // radii do not grow from trial to trial
  deform(warm, stretch, {}, &guess);
  EXPECT_EQ(warm.radius, trial.radius);
}

TEST(MdrCell, BytesReplayToTheLastBit)
{
  UnitCell cell = grown_cell();
  std::vector<char> bytes;
  to_bytes(cell, bytes);
  UnitCell again = from_bytes(bytes);
  EXPECT_EQ(again, cell);
  EXPECT_EQ(take_to(again, 0.94), take_to(cell, 0.94));
  EXPECT_EQ(again, cell);
}

TEST(MdrCell, BytesWithWrongInitialSizesAreRefused)
{
  const auto refused = [](auto &&change) {
    UnitCell cell = grown_cell();
    change(cell.initial_radius);
    std::vector<char> bytes;
    to_bytes(cell, bytes);
    EXPECT_THROW((void)from_bytes(bytes), std::runtime_error);
  };
  refused([](std::vector<double> &radius) { radius.pop_back(); });
  refused([](std::vector<double> &radius) { radius[7] = 0; });
}

/// All pairs of grains nearer to each other than R_i + R_j + gap.
std::vector<Pair> near_pairs(const PeriodicBox &box,
                             const std::vector<Vector3> &place,
                             const std::vector<double> &radius,
                             double gap)
{
  std::vector<Pair> pairs;
  for (std::uint32_t i = 0; i < place.size(); ++i)
    for (std::uint32_t j = i + 1; j < place.size(); ++j)
      if (box.nearest_image(place[j] - place[i]).norm() <
          radius[i] + radius[j] + gap)
        pairs.push_back({i, j});
  return pairs;
}

TEST(MdrCell, NoPairIsMissedWhereGrainsGrow)
{
  UnitCell cell = mdr_cell();
  for (double density : {0.85, 0.9, 0.95}) {
    take_to(cell, density);
    deform(cell, Matrix3::Identity(), {});
    std::vector<Pair> touching;
    for (const ContactForce &contact : contact_forces(cell))
      touching.push_back(contact.pair);
    EXPECT_EQ(touching, near_pairs(cell.box, cell.place, cell.radius, 0));
    // The list still holds all that it claims to hold.
    const Neighbours &list = cell.neighbours;
    EXPECT_TRUE(std::ranges::includes(
        list.pairs,
        near_pairs({list.box}, list.place, cell.radius, list.skin)));
  }
}

TEST(MdrCell, SinglePrecisionIsEnough)
{
  // Half a per cent of the pressure, as for other laws after as long a way.
  constexpr double tolerance = 5e-3;
  Driving mixed;
  mixed.arithmetic.precision = Precision::mixed;
  UnitCell one = grown_cell(), two = grown_cell();
  EXPECT_NEAR(take_to(one, 0.96) / take_to(two, 0.96, mixed), 1, tolerance);
}

TEST(MdrCell, GrowsAlikeBesideLawsWithNumbersOfTheirOwn)
{
  // They stand behind those of the normal law in the memory. Another packing,
  // a little.
  constexpr double tolerance = 0.15;
  const auto growth = [](const UnitCell &cell) {
    double sum = 0;
    for (std::size_t g = 0; g < cell.size(); ++g)
      sum += cell.radius[g] - cell.initial_radius_of(g);
    return sum;
  };
  UnitCell plain = mdr_cell();
  const double pressure = take_to(plain, 0.8);
  for (RollingLaw rolling : {RollingLaw::none, RollingLaw::epsd}) {
    UnitCell cell = mdr_cell();
    cell.contact.tangential_law = TangentialLaw::mindlin_deresiewicz;
    cell.contact.rolling_law = rolling;
    cell.contacts.clear();
    cell.more_memory.clear();
    EXPECT_NEAR(take_to(cell, 0.8) / pressure, 1, tolerance);
    EXPECT_NEAR(growth(cell) / growth(plain), 1, tolerance);
  }
}

TEST(MdrCell, EveryInstructionSetGivesTheSame)
{
  constexpr double tolerance = 1e-9; // rounding, through a relaxation
  Driving driving;
  driving.arithmetic.instruction_set = InstructionSet::scalar;
  UnitCell scalar = grown_cell();
  const double pressure = take_to(scalar, 0.91, driving);
  for (InstructionSet set : instruction_sets()) {
    driving.arithmetic.instruction_set = set;
    UnitCell cell = grown_cell();
    EXPECT_NEAR(take_to(cell, 0.91, driving) / pressure, 1, tolerance);
    EXPECT_NEAR(cell.radius[0] / scalar.radius[0], 1, tolerance);
  }
}

TEST(MdrCell, MixturesAreRefusedWithTheReason)
{
  PackingRequest request = request_for(NormalLaw::mdr);
  EXPECT_EQ(message_of<std::invalid_argument>([&] { request.check(); }), "");
  request.others = {{0.5, request.sizes, request.material}};
  EXPECT_NE(message_of<std::invalid_argument>([&] { request.check(); })
                .find("normal law mdr: its contacts are of two grains of one "
                      "material"),
            std::string::npos);
  request.others.clear();
  request.contact.bulk_onset = 1;
  EXPECT_NE(message_of<std::invalid_argument>([&] {
              request.check();
            }).find("bulk onset = 1"),
            std::string::npos);
}

TEST(MdrCell, HighDensityIsNoRemark)
{
  const UnitCell &cell = grown_cell();
  for (const Remark &remark : judge(cell, {}, 1e6))
    EXPECT_NE(remark.kind, Remark::Kind::beyond_pair_laws);
}
} // namespace
} // namespace tamp::dem
