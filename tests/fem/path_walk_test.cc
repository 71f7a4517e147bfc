// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/path_walk.h>

#include <gtest/gtest.h>

namespace tamp::fem
{
namespace
{
using Control = ComponentTarget::Control;

ContinuumPoints<DruckerPragerCap> cap_points()
{
  return {DruckerPragerCap(), 1};
}

// A stage of every kind: pressed, unloaded until a stress that is hit within
// an increment, sheared by gradients, by increments, under constant pressure.
std::vector<PathStage> all_kinds()
{
  std::vector<PathStage> stages(5);
  for (PathStage &stage : stages)
    stage.maximum_increment = 5e-3;
  stages[0].components[2].value = -0.12;
  for (const unsigned lateral : {0u, 1u})
    stages[0].components[lateral] = {Control::stress, -2e6, false};
  stages[1].components[2] = {Control::strain, 0.05, true};
  stages[1].has_until = true;
  stages[1].until_stress = -1e6;
  stages[1].maximum_increment = 1e-3;
  const dealii::Tensor<2, 3> one = dealii::unit_symmetric_tensor<3>();
  for (unsigned i = 1; i <= 3; ++i) {
    stages[2].gradients.push_back(one);
    stages[2].gradients.back()[0][2] = -2e-3 * i;
    stages[3].increments.push_back(one);
    stages[3].increments.back()[2][2] = 1 - 1e-3 * i;
  }
  stages[4].components[2] = {Control::strain, -0.02, true};
  stages[4].axial_share = 0.5;
  for (const unsigned lateral : {0u, 1u})
    stages[4].components[lateral] = {Control::stress, -4.5e6, false};
  return stages;
}

/// A point and its way, and all that it came by.
struct Walker {
  explicit Walker(const std::vector<PathStage> &stages)
      : walk(points, stages, {}, 1e-3)
  {
  }
  bool step() { return !(end = walk.advance()); }

  ContinuumPoints<DruckerPragerCap> points = cap_points();
  PathWalk walk;
  std::optional<PathEnd> end;
};

TEST(PathWalk, GoesOnFromAnyStepToTheBit)
{
  const std::vector<PathStage> stages = all_kinds();
  Walker whole(stages);
  std::vector<PathRecord> records;
  std::vector<std::vector<char>> walks, states;
  while (whole.step()) {
    records.push_back(whole.walk.last());
    whole.walk.pack(walks.emplace_back());
    whole.points.pack(0, states.emplace_back());
  }
  ASSERT_EQ(whole.end, PathEnd::finished);
  ASSERT_EQ(records.back().stage, stages.size() - 1);
  for (std::size_t from = 0; from < records.size(); ++from) {
    Walker again(stages);
    again.points.unpack(0, states[from]);
    StateBytes bytes(walks[from]);
    again.walk.unpack(bytes);
    EXPECT_TRUE(bytes.empty());
    std::size_t step = from;
    while (again.step()) {
      ASSERT_LT(++step, records.size());
      EXPECT_EQ(again.walk.last().stage, records[step].stage);
      EXPECT_EQ(again.walk.last().F, records[step].F);
      EXPECT_EQ(again.walk.last().response.stress,
                records[step].response.stress);
    }
    EXPECT_EQ(again.end, PathEnd::finished);
    EXPECT_EQ(step, records.size() - 1);
  }
}

TEST(PathWalk, ReplaysTheIncrementsThatAPathTook)
{
  // A rotation that F_new F_old^-1 would not give back to the bit.
  std::vector<dealii::Tensor<2, 3>> increments(
      4, dealii::unit_symmetric_tensor<3>());
  for (std::size_t i = 0; i < increments.size(); ++i) {
    increments[i][2][2] = 1 - 0.003 * static_cast<double>(i + 1);
    increments[i][0][2] = 0.001;
  }
  auto points = cap_points(), alone = cap_points();
  std::vector<Response> answer(1);
  const auto evaluate = [&](const dealii::Tensor<2, 3> &relative_F) {
    alone.begin_attempt();
    alone.evaluate(
        std::vector<Deformation>{{relative_F}}, Want::stress, answer);
  };
  EXPECT_EQ(drive_increments(points,
                             increments,
                             [&](const PathRecord &record) {
                               if (record.step == 0)
                                 return;
                               evaluate(increments[record.step - 1]);
                               EXPECT_EQ(record.response.stress,
                                         answer[0].stress);
                               alone.commit();
                             }),
            PathEnd::finished);
}

TEST(PathWalk, BytesOfOtherStagesAreRefused)
{
  const std::vector<PathStage> stages = all_kinds();
  Walker whole(stages);
  while (whole.step()) {
  }
  std::vector<char> bytes;
  whole.walk.pack(bytes);
  const std::vector<PathStage> fewer(stages.begin(), stages.begin() + 2);
  Walker other(fewer);
  StateBytes stored(bytes);
  EXPECT_THROW(other.walk.unpack(stored), std::runtime_error);
  StateBytes cut(std::span<const char>(bytes).first(bytes.size() - 1));
  EXPECT_THROW(other.walk.unpack(cut), std::runtime_error);
}
} // namespace
} // namespace tamp::fem
