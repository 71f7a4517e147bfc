// SPDX-License-Identifier: BSD-3-Clause
#include <tests/fem/press_trip.h>

#include <algorithm>
#include <gtest/gtest.h>

namespace tamp::fem
{
namespace
{
using namespace test;

/// Ejections of a compact that was pressed, by both kinds.
class Ejections : public testing::TestWithParam<Ejection>
{
protected:
  static Trip eject(StageTarget target, double value, double share)
  {
    return Trip(schedule_of(
        {press_by(Pressing::upper, StageTarget::displacement, 1e-3),
         {StageKind::eject, target, value, share, 1, {}, GetParam()}}));
  }
};
} // namespace

INSTANTIATE_TEST_SUITE_P(Schedule,
                         Ejections,
                         testing::Values(Ejection::push, Ejection::withdrawal));

TEST_P(Ejections, EndAtTheRimOutOfTheDieOrAfterALength)
{
  for (const double share : {0.05, 0.}) {
    const Trip rim = eject(StageTarget::rim, 0, share);
    EXPECT_NEAR(rim.end().top, rim.end().rim, 1e-6 * Press::height);
    const Trip out = eject(StageTarget::out, 0, share);
    EXPECT_NEAR(out.end().bottom, out.end().rim, 1e-9 * Press::height);
    const Trip length = eject(StageTarget::displacement, 2e-3, share);
    EXPECT_NEAR(length.end().lower_displacement - length.end().die_displacement,
                2e-3,
                1e-9 * Press::height);
    for (const Trip *run : {&rim, &out, &length}) {
      EXPECT_NEAR(run->end().force[upper_punch],
                  share * run->end().peak_force,
                  1e-9 * run->end().peak_force);
      const bool pushes = GetParam() == Ejection::push;
      EXPECT_EQ(run->end().lower_displacement > 0, pushes);
      EXPECT_EQ(run->end().die_displacement < 0, !pushes);
    }
  }
}

TEST_P(Ejections, AFreeCompactIsNeverTouchedAgain)
{
  const Trip run = eject(StageTarget::out, 0, 0);
  // The compact of this press keeps its height: the gap must only grow.
  bool free = false;
  for (const Step &step : run.of(1)) {
    free = free || step.before.force[upper_punch] == 0;
    EXPECT_FALSE(step.proposal.motion[upper_punch].loaded);
    if (free) {
      EXPECT_EQ(step.after.force[upper_punch], 0);
      EXPECT_GT(step.after.height, step.before.height);
    }
  }
  EXPECT_TRUE(free);
}

TEST_P(Ejections, LeavePointsTheirPressureUntilTheyPassTheRim)
{
  const Trip run(schedule_of(
      {press_by(Pressing::upper, StageTarget::displacement, 1e-3),
       unload_to(StageTarget::peak_share, 0.05),
       {StageKind::eject, StageTarget::out, 0, 0.05, 1, {}, GetParam()}}));
  for (const Step &step : run.of(0))
    EXPECT_EQ(step.kept, 1);
  for (const Step &step : run.of(1))
    EXPECT_NEAR(step.kept,
                step.after.force[upper_punch] / step.before.force[upper_punch],
                rounding);
  unsigned inside = 0, passing = 0;
  for (const Step &step : run.of(2)) {
    const bool in = step.after.top <= step.after.rim + 1e-7 * Press::height;
    ++(in ? inside : passing);
    EXPECT_EQ(step.kept, in ? 1 : 0);
  }
  EXPECT_GT(inside, 0u);
  EXPECT_GT(passing, 0u);
}

TEST_P(Ejections, JumpInsideTheDieAndPassTheRimInPartsOfAnElement)
{
  const Trip run = eject(StageTarget::out, 0, 0.05);
  const double limit = StepLimits().rim;
  double largest_inside = 0, element = 0;
  for (const Step &step : run.of(1))
    if (step.after.top > step.after.rim + 1e-9 * Press::height) {
      element = step.before.element_height;
      EXPECT_LE(step.proposal.driving,
                limit * step.before.element_height * (1 + rounding));
    } else {
      largest_inside = std::max(largest_inside, step.proposal.driving);
    }
  // The limit is one: steps were longer before.
  EXPECT_GT(largest_inside, 1.3 * limit * element);
  // Forty steps and a few until it slides in steps of the largest size.
  EXPECT_LE(run.of(1).size(), Press::elements / limit + 45);
}

TEST(Schedule, AnEjectionMayHoldAPunchThatWasClear)
{
  const Trip run(
      schedule_of({press_by(Pressing::both, StageTarget::displacement, 5e-4),
                   unload_to(StageTarget::nothing, 0),
                   {StageKind::eject, StageTarget::rim, 0, 0.05}}));
  EXPECT_NEAR(run.end().force[upper_punch],
              0.05 * run.end().peak_force,
              1e-9 * run.end().peak_force);
  EXPECT_NEAR(run.end().top, run.end().rim, 1e-6 * Press::height);
}

} // namespace tamp::fem
