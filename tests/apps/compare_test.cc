// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/compared_curves.h>
#include <apps/compare/compared_fields.h>
#include <apps/compare/curve_difference.h>
#include <apps/compare/field_grid.h>
#include <apps/input/units.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>
#include <unistd.h>

using namespace tamp::apps;

namespace
{
/// y = slope x at these places.
PlainCurve line(double slope, const std::vector<double> &places)
{
  PlainCurve curve{places, {}};
  for (const double x : places)
    curve.y.push_back(slope * x);
  return curve;
}

/// Elements of a half section between r = 0, R and z = 0, H, each in four
/// parts; inner nodes are moved aside, so that parts are no rectangles.
FieldGrid skew_grid(unsigned columns, unsigned rows, double R, double H)
{
  FieldGrid grid;
  const auto node = [&](unsigned i, unsigned j) {
    const bool inner = i > 0 && i < columns && j > 0 && j < rows;
    const double aside = inner ? 0.2 : 0;
    return Place{R * (i + aside) / columns, H * (j - 0.7 * aside) / rows, 0};
  };
  for (unsigned j = 0; j < rows; ++j)
    for (unsigned i = 0; i < columns; ++i)
      for (unsigned part = 0; part < 4; ++part)
        for (unsigned corner = 0; corner < 4; ++corner) {
          const double a = 0.5 * ((part & 1) + (corner & 1));
          const double b = 0.5 * ((part >> 1) + (corner >> 1));
          Place place{};
          for (int axis = 0; axis < 2; ++axis)
            place[axis] = (1 - a) * (1 - b) * node(i, j)[axis] +
                          a * (1 - b) * node(i + 1, j)[axis] +
                          (1 - a) * b * node(i, j + 1)[axis] +
                          a * b * node(i + 1, j + 1)[axis];
          grid.undeformed.push_back(place);
        }
  grid.now = grid.undeformed;
  return grid;
}

double linear_field(const Place &place)
{
  return 0.5 + 3 * place[0] - 2 * place[1];
}

void fill(FieldGrid &grid)
{
  auto &density = grid.values["relative_density"];
  for (const Place &place : point_places(grid.dimension, grid.undeformed))
    density.push_back(linear_field(place));
}
} // namespace

TEST(Compare, LinesOfSlopesTenPerCentApartDifferByTenPerCent)
{
  const PlainCurve reference = line(1, {0, 0.3, 0.7, 2});
  const auto found = difference_of(reference, line(1.1, {0, 0.5, 2}));
  ASSERT_TRUE(found);
  // Sums of a few numbers of order 1.
  EXPECT_NEAR(found->relative_L2, 0.1, 1e-14);
  EXPECT_NEAR(found->relative_largest, 0.1, 1e-14);
  EXPECT_EQ(found->at, 2);
  EXPECT_EQ(found->from, 0);
  EXPECT_EQ(found->to, 2);
}

TEST(Compare, IntegralsOfDifferencesAreExact)
{
  // y = 1 against y = x on [0, 2]: the integral of (x - 1)^2 is 2/3, that of 1
  // is 2.
  const PlainCurve one{{0, 2}, {1, 1}};
  const auto found = difference_of(one, line(1, {0, 2}));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->relative_L2, std::sqrt(1. / 3), 1e-14); // rounding
  EXPECT_NEAR(found->relative_largest, 1, 1e-14);
}

TEST(Compare, MorePointsOnTheSameLinesChangeNothing)
{
  const PlainCurve other = line(1.3, {0, 1});
  const auto coarse = difference_of(line(1, {0, 1}), other);
  const auto fine = difference_of(line(1, {0, 0.11, 0.5, 0.77, 1}), other);
  ASSERT_TRUE(coarse && fine);
  EXPECT_NEAR(coarse->relative_L2, fine->relative_L2, 1e-14); // rounding
}

TEST(Compare, OnlyTheCommonRangeCounts)
{
  PlainCurve other = line(1, {0.5, 1, 3});
  other.y.back() = 1e6;
  const auto found = difference_of(line(1, {0, 1}), other);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->from, 0.5);
  EXPECT_EQ(found->to, 1);
  EXPECT_NEAR(found->relative_L2, 0, 1e-14); // rounding
  EXPECT_FALSE(difference_of(line(1, {0, 1}), line(1, {1, 2})));
  EXPECT_FALSE(difference_of(line(0, {0, 1}), line(1, {0, 1})));
}

TEST(Compare, LoadingPartLeavesOutWhatTurnsBack)
{
  const std::vector<double> x{0, 1, 0.5, 1, 2, std::nan("")};
  const std::vector<double> y{0, 1, 7, 7, 2, 7};
  const PlainCurve up = monotone_part(x, y);
  EXPECT_EQ(up.x, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(up.y, (std::vector<double>{0, 1, 2}));
  // What falls, as a density while unloading, is turned over.
  const PlainCurve down = monotone_part(std::vector<double>{2, 1, 1.5, 0},
                                        std::vector<double>{4, 3, 9, 2});
  EXPECT_EQ(down.x, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(down.y, (std::vector<double>{2, 3, 4}));
}

TEST(Compare, LinearFieldsAreResampledExactly)
{
  FieldGrid coarse = skew_grid(3, 2, 6e-3, 7e-3);
  fill(coarse);
  const FieldGrid fine = skew_grid(5, 7, 6e-3, 7e-3);
  const auto places = point_places(2, fine.undeformed);
  const SampledFields found = sample(coarse, places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    ASSERT_TRUE(found.inside[i]);
    // VTK finds a place in a skew part to 1e-4 of it, with one more iteration
    // of second order: 1e-8 of a range of 0.02.
    EXPECT_NEAR(
        found.values.at("relative_density")[i], linear_field(places[i]), 1e-9);
  }
}

TEST(Compare, PlacesBeyondTheOtherMeshAreOutside)
{
  FieldGrid grid = skew_grid(3, 2, 6e-3, 7e-3);
  fill(grid);
  const SampledFields found =
      sample(grid, std::vector<Place>{{3e-3, 3e-3, 0}, {7e-3, 3e-3, 0}});
  EXPECT_TRUE(found.inside[0]);
  EXPECT_FALSE(found.inside[1]);
}

TEST(Compare, VolumesOfRingsSumUpToTheCylinder)
{
  const FieldGrid grid = skew_grid(4, 3, 6e-3, 7e-3);
  double sum = 0;
  for (const double volume : part_volumes(2, grid.now))
    sum += volume;
  const double cylinder = std::numbers::pi * 6e-3 * 6e-3 * 7e-3;
  // Two Gauss points an axis are exact for r times the Jacobian: rounding.
  EXPECT_NEAR(sum / cylinder, 1, 1e-13);
}

TEST(Compare, UnequalSizesAreMatchedShareByShare)
{
  FieldGrid grid = skew_grid(3, 2, 6e-3, 7e-3);
  FieldGrid twice = skew_grid(3, 2, 12e-3, 14e-3);
  EXPECT_FALSE(same_mesh(grid, twice));
  normalise(grid);
  normalise(twice);
  EXPECT_TRUE(same_mesh(grid, twice));
  EXPECT_NEAR(extent_of(grid).size[0], 1, 1e-15); // rounding
  EXPECT_NEAR(extent_of(grid).size[1], 1, 1e-15);
}

namespace
{
/// A curve.csv with these lines.
class Curves : public testing::Test
{
protected:
  ResultCurve read(const std::string &text) const
  {
    std::ofstream(file) << text;
    return ResultCurve(file);
  }
  std::string complaint(const std::string &text) const
  {
    try {
      read(text);
    } catch (const InputError &error) {
      return error.what();
    }
    return {};
  }
  void TearDown() override { std::filesystem::remove(file); }

  const std::filesystem::path file =
      std::filesystem::temp_directory_path() /
      ("tamp_compare_" + std::to_string(getpid()) + ".csv");
};
} // namespace

TEST_F(Curves, StagesBeginWhereTheOneBeforeEnds)
{
  const ResultCurve curve = read("# stage 1: press\n# stage 2: unload to 5 %\n"
                                 "step,stage,a[m]\n0,1,0\n1,1,1\n2,2,3\n");
  ASSERT_EQ(curve.stages().size(), 2u);
  EXPECT_EQ(curve.stages()[1].first, 1u);
  EXPECT_EQ(curve.stages()[1].last, 2u);
  EXPECT_EQ(curve.kind(2), "unload");
  EXPECT_EQ(curve.column("a[m]"), (std::vector<double>{0, 1, 3}));
}

TEST_F(Curves, DamageIsNamedWithItsLine)
{
  EXPECT_NE(complaint("a[m],b[m]\n1,2\n3\n").find(".csv:3:"),
            std::string::npos);
  EXPECT_NE(complaint("a[m],b[m]\n1,two\n").find("'two'"), std::string::npos);
  EXPECT_NE(complaint("a[m],b[m]\n1,nan\n").find("'nan'"), std::string::npos);
  EXPECT_NE(complaint("a[m],a[m]\n1,2\n").find("'a[m]'"), std::string::npos);
  EXPECT_NE(complaint("1,2\n3,4\n").find("'1'"), std::string::npos);
  EXPECT_NE(complaint("a[m]\n").find("no line"), std::string::npos);
  EXPECT_NE(complaint("").find("no line"), std::string::npos);
}
