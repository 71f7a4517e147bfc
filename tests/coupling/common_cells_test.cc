// SPDX-License-Identifier: BSD-3-Clause
#include <tests/coupling/sample_cells.h>

#include <gtest/gtest.h>
#include <memory>
#include <utility>
#include <vector>

namespace tamp::coupling
{
namespace
{
using fem::Deformation;
using fem::Response;
using fem::Want;
using test::pressed;

std::vector<char> bytes_of(const UnitCellPoints &points, std::size_t i)
{
  std::vector<char> bytes;
  points.pack(i, bytes);
  return bytes;
}

/// Points of one packing next to the same points each on its own, which are
/// all asked the same and must answer the same, to the bit.
class Together
{
public:
  explicit Together(std::size_t count)
      : points({test::sample_cell()}, std::vector<std::size_t>(count, 0), {}),
        answers_(count)
  {
    for (std::size_t i = 0; i < count; ++i)
      alone_.push_back(std::make_unique<UnitCellPoints>(test::same_cells(1),
                                                        CellPointsOptions()));
  }

  void begin_attempt()
  {
    points.begin_attempt();
    for (const auto &one : alone_)
      one->begin_attempt();
  }

  void ask(const std::vector<Deformation> &all)
  {
    points.evaluate(all, Want::stress_and_tangent, answers_);
    std::uint64_t evaluations = 0;
    for (std::size_t i = 0; i < alone_.size(); ++i) {
      Response answer;
      alone_[i]->evaluate({&all[i], 1}, Want::stress_and_tangent, {&answer, 1});
      EXPECT_EQ(answers_[i].stress, answer.stress) << "point " << i;
      EXPECT_EQ(answers_[i].tangent, answer.tangent) << "point " << i;
      EXPECT_EQ(answers_[i].status, answer.status) << "point " << i;
      evaluations += alone_[i]->report().evaluations;
    }
    EXPECT_EQ(points.report().evaluations, evaluations);
  }

  void press(const std::vector<double> &strains)
  {
    std::vector<Deformation> all;
    for (const double strain : strains)
      all.push_back(pressed(strain));
    ask(all);
  }

  void commit()
  {
    points.commit();
    for (std::size_t i = 0; i < alone_.size(); ++i) {
      alone_[i]->commit();
      EXPECT_EQ(bytes_of(points, i), bytes_of(*alone_[i], 0)) << "point " << i;
    }
  }

  std::size_t cells() const { return points.report().cells; }

  UnitCellPoints points;

private:
  std::vector<std::unique_ptr<UnitCellPoints>> alone_;
  std::vector<Response> answers_;
};

TEST(CommonCells, PointsToldTheSameCostOneCell)
{
  Together all(5);
  for (int step = 0; step < 3; ++step) {
    all.begin_attempt();
    all.press(std::vector<double>(5, 4e-3));
    all.press(std::vector<double>(5, 5e-3));
    EXPECT_EQ(all.cells(), 1u);
    EXPECT_EQ(5 * all.points.report().done_evaluations,
              all.points.report().evaluations);
    all.commit();
  }
}

TEST(CommonCells, PartInTheTrialThatTellsThemApart)
{
  Together all(4);
  all.begin_attempt();
  all.press({4e-3, 4e-3, 4e-3, 4e-3});
  EXPECT_EQ(all.cells(), 1u);
  all.press({4e-3, 5e-3, 4e-3, 5e-3});
  EXPECT_EQ(all.cells(), 2u);
  // Their warm starts are two by now: they stay apart.
  all.press({5e-3, 5e-3, 5e-3, 5e-3});
  EXPECT_EQ(all.cells(), 2u);
  all.commit();
  all.begin_attempt();
  all.press({5e-3, 5e-3, 5e-3 + 0x1p-52, 5e-3});
  EXPECT_EQ(all.cells(), 3u); // the last bit tells
  all.commit();
}

TEST(CommonCells, AreOneAgainWhereAnAttemptIsGivenUp)
{
  Together all(4);
  all.begin_attempt();
  all.press({4e-3, 5e-3, 6e-3, 6e-3});
  all.press({4e-3, 5e-3, 6e-3, 7e-3});
  EXPECT_EQ(all.cells(), 4u);
  all.begin_attempt();
  all.press({2e-3, 2e-3, 3e-3, 3e-3});
  EXPECT_EQ(all.cells(), 2u);
  all.commit();
}

TEST(CommonCells, RotatedPointsKeepTheirCell)
{
  // Every increment is a stretch of sample points and a turn of each one's own.
  Together all(3);
  for (int step = 0; step < 2; ++step) {
    std::vector<Deformation> turned(3, pressed(0));
    for (std::size_t i = 0; i < 3; ++i) {
      // A quarter turn about z keeps all bits.
      const double cosine = i == 1 ? 0 : 1, sine = i == 1 ? 1 : 0;
      dealii::Tensor<2, 3> turn;
      turn[0][0] = turn[1][1] = cosine;
      turn[1][0] = -(turn[0][1] = -sine);
      turn[2][2] = 1;
      turned[i].relative_F = turn * pressed(4e-3).relative_F;
    }
    all.begin_attempt();
    all.ask(turned);
    EXPECT_EQ(all.cells(), 1u);
    all.commit();
  }
}

TEST(CommonCells, FailuresAreThoseOfThePointsThatAskForThem)
{
  Together all(4);
  all.begin_attempt();
  all.press({4e-3, 2., 4e-3, 2.}); // turned inside out
  EXPECT_EQ(all.points.report().problem.find("material point 1: "), 0u)
      << all.points.report().problem;
  all.begin_attempt();
  all.press({4e-3, 4e-3, 4e-3, 4e-3});
  EXPECT_EQ(all.cells(), 1u);
  all.commit();
}

TEST(CommonCells, UnpackedStatesFindTheirCellAgain)
{
  Together all(4);
  all.begin_attempt();
  all.press({4e-3, 5e-3, 4e-3, 5e-3});
  all.commit();
  UnitCellPoints fresh(test::same_cells(4), {});
  for (std::size_t i = 0; i < 4; ++i) {
    fresh.unpack(i, bytes_of(all.points, i));
    EXPECT_EQ(bytes_of(fresh, i), bytes_of(all.points, i));
  }
  std::vector<Response> wanted(4), answers(4);
  const std::vector<Deformation> next(4, pressed(3e-3));
  all.points.evaluate(next, Want::stress, wanted);
  fresh.evaluate(next, Want::stress, answers);
  EXPECT_EQ(fresh.report().cells, 2u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(answers[i].stress, wanted[i].stress);
}

TEST(CommonCells, PointsThatMoveAwayTakeTheirStateAlong)
{
  Together all(4);
  all.begin_attempt();
  all.press({4e-3, 4e-3, 5e-3, 5e-3});
  all.commit();
  std::vector<std::vector<char>> states;
  for (std::size_t i = 0; i < 4; ++i)
    states.push_back(bytes_of(all.points, i));
  all.points.hold({1, 5});
  all.points.unpack(3, states[0]);
  EXPECT_EQ(bytes_of(all.points, 0), states[1]);
  EXPECT_EQ(bytes_of(all.points, 1), states[2]);
  EXPECT_EQ(bytes_of(all.points, 2), states[3]);
  EXPECT_EQ(bytes_of(all.points, 3), states[0]);
  std::vector<Response> answers(4);
  all.points.evaluate(
      std::vector<Deformation>(4, pressed(3e-3)), Want::stress, answers);
  EXPECT_EQ(all.points.report().cells, 2u);
  EXPECT_EQ(answers[0].stress, answers[3].stress);
  // Its work is that of the first one that has it.
  EXPECT_GT(all.points.cost(0), 0);
  EXPECT_EQ(all.points.cost(3), 0);
}
} // namespace
} // namespace tamp::coupling
