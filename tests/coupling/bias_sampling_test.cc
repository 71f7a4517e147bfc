// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/bias_sampling.h>
#include <coupling/polar.h>
#include <dem/stretch.h>
#include <tests/coupling/sample_cells.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <memory>
#include <set>
#include <vector>

namespace tamp::coupling
{
namespace
{
constexpr std::size_t count = 4;

CellPointsOptions with_tolerance(double tolerance)
{
  CellPointsOptions options;
  options.driving.quasi_static.unbalance_tolerance = tolerance;
  return options;
}

/// Cells that have been asked for an increment.
struct AskedCells {
  SharedCells cells;
  std::vector<CellIncrement> increments;

  explicit AskedCells(const CellPointsOptions &options)
      : cells(std::make_unique<UnitCellPoints>(test::different_cells(count),
                                               options),
              count,
              fem::Ranks())
  {
    std::vector<fem::Deformation> all(count);
    for (std::size_t i = 0; i < count; ++i) {
      for (unsigned axis = 0; axis < 3; ++axis)
        all[i].relative_F[axis][axis] = 1;
      all[i].relative_F[2][2] -= 4e-3 + 5e-4 * double(i);
      all[i].relative_F[0][2] = 1e-3;
    }
    std::vector<fem::Response> answers(count);
    cells.evaluate(all, fem::Want::stress, answers);
    for (std::size_t i = 0; i < count; ++i)
      increments.push_back({i, all[i], answers[i].stress});
  }
};

std::vector<char> bytes_of(const fem::MaterialPoints &points)
{
  std::vector<char> bytes;
  for (std::size_t i = 0; i < points.size(); ++i)
    points.pack(i, bytes);
  return bytes;
}
} // namespace

TEST(BiasSampling, MeetsAllPointsInTurn)
{
  for (const std::size_t points : {1, 2, 3, 7, 16, 100, 112, 400, 1023}) {
    std::set<std::size_t> met;
    for (std::size_t number = 0; met.size() < points; ++number) {
      const auto now = sampled_points(number, points);
      ASSERT_FALSE(now.empty());
      ASSERT_LE(now.size(), std::max<std::size_t>(1, points / 4));
      const std::size_t left = points - met.size();
      for (const std::size_t point : now) {
        ASSERT_LT(point, points);
        met.insert(point);
      }
      // Until all have had their turn nobody comes twice.
      ASSERT_EQ(points - met.size(), left - std::min(left, now.size()));
    }
  }
}

TEST(BiasSampling, DrivesACellInThreeTimesAsManyPartsBalancedTenTimesBetter)
{
  // As if somebody did it by hand, from the committed state, without a warm
  // start.
  const CellPointsOptions options = with_tolerance(1e-3);
  AskedCells asked(options);
  const auto answers =
      answer_finely(asked.cells, asked.increments, options.driving, 2);
  ASSERT_EQ(answers.size(), count);
  dem::Driving by_hand;
  by_hand.quasi_static.unbalance_tolerance = 1e-4;
  for (std::size_t i = 0; i < count; ++i) {
    const PolarSplit split =
        polar_split(to_matrix(asked.increments[i].deformation.relative_F));
    dem::UnitCell cell = test::different_cells(count)[i];
    const double strain = dem::largest_principal(dem::logarithm(split.stretch));
    by_hand.quasi_static.maximum_strain_increment = strain / 2.5; // 3 parts
    const dem::CellAnswer wanted = deform(cell, split.stretch, by_hand);
    EXPECT_TRUE(answers[i].settled);
    EXPECT_EQ(answers[i].evaluations, double(wanted.evaluations));
    const dem::Matrix3 stress =
        split.rotation * wanted.stress * split.rotation.transpose();
    EXPECT_LT((answers[i].stress - to_tensor(stress)).norm(),
              1e-9 * answers[i].stress.norm()); // round-off of the parts
  }
}

TEST(BiasSampling, ChangesNothing)
{
  const CellPointsOptions options = with_tolerance(1e-3);
  AskedCells asked(options), left_alone(options);
  answer_finely(asked.cells, asked.increments, options.driving, 1);
  EXPECT_EQ(asked.cells.report().evaluations,
            left_alone.cells.report().evaluations);
  std::vector<fem::Deformation> next;
  for (CellIncrement &increment : asked.increments) {
    increment.deformation.relative_F[2][2] -= 1e-4;
    next.push_back(increment.deformation);
  }
  // A warm start is kept, too.
  std::vector<fem::Response> answers(count), wanted(count);
  asked.cells.evaluate(next, fem::Want::stress, answers);
  left_alone.cells.evaluate(next, fem::Want::stress, wanted);
  for (std::size_t i = 0; i < count; ++i)
    EXPECT_EQ(answers[i].stress, wanted[i].stress);
  asked.cells.commit();
  left_alone.cells.commit();
  EXPECT_EQ(bytes_of(asked.cells), bytes_of(left_alone.cells));
}

TEST(BiasSampling, SeesCellsThatAreBalancedBadly)
{
  const auto bias = [](double tolerance) {
    const CellPointsOptions options = with_tolerance(tolerance);
    AskedCells asked(options);
    const auto finer =
        answer_finely(asked.cells, asked.increments, options.driving, 1);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
      sum += (finer[i].stress - asked.increments[i].stress).norm() /
             finer[i].stress.norm();
    return sum / double(count);
  };
  const double bad = bias(3e-2), good = bias(1e-3), better = bias(1e-5);
  std::cout << "bias at unbalances of 3e-2, 1e-3, 1e-5: " << bad << ", " << good
            << ", " << better << "\n";
  EXPECT_GT(bad, 3 * good);
  EXPECT_LT(good, 1e-2);
}
} // namespace tamp::coupling
