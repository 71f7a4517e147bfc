// SPDX-License-Identifier: BSD-3-Clause
#include <tests/fem/press_trip.h>

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using namespace test;

/// Steps from `first` on that grow to the largest one cover this strain.
std::size_t steps_for(double strain, double first, double largest)
{
  std::size_t count = 0;
  for (double step = first; strain > 0;
       step = std::min(largest, StepLimits().growth * step), ++count)
    strain -= step;
  return count;
}
} // namespace

TEST(Schedule, StepsGrowToTheMaximumAndLandWithoutSlivers)
{
  const StepLimits limits;
  const Trip run(
      schedule_of({press_by(Pressing::upper, StageTarget::density, 0.6)}));
  EXPECT_NEAR(run.end().mean_density, 0.6, rounding);
  EXPECT_DOUBLE_EQ(run.steps.front().proposal.strain, limits.first);
  for (const Step &step : run.steps) {
    EXPECT_LE(step.proposal.strain, limits.maximum * (1 + 1e-6));
    EXPECT_GE(step.proposal.strain, 0.4 * limits.first);
  }
  // The last two parts are alike: one step more than the way needs.
  EXPECT_LE(run.steps.size(),
            1 + steps_for(std::log(0.6 / 0.5), limits.first, limits.maximum));
}

TEST(Schedule, EveryPunchPressesToADensityAndOnlyThoseMoveThatPress)
{
  for (const auto who : {Pressing::upper, Pressing::lower, Pressing::both})
    for (const double faces : {0., 0.2 * Press::height, -0.2 * Press::height}) {
      Press start;
      start.faces = faces;
      const Trip run(schedule_of({press_by(who, StageTarget::density, 0.6)}),
                     start);
      // Between curved faces the last step starts from the slope of the one
      // before it, which is exact: volume is linear in the height.
      EXPECT_NEAR(run.end().mean_density, 0.6, 1e-10);
      const double upper = run.end().upper_displacement;
      const double lower = run.end().lower_displacement;
      EXPECT_EQ(upper > 0, who != Pressing::lower);
      EXPECT_EQ(lower > 0, who != Pressing::upper);
      if (who == Pressing::both) {
        EXPECT_NEAR(upper, lower, rounding * Press::height);
      }
      EXPECT_LE(run.steps.size(), 70u);
      for (const Step &step : run.steps)
        EXPECT_LE(step.after.height, step.before.height);
    }
}

TEST(Schedule, ADensityThatALandingMissedIsLandedOnAgain)
{
  Press start;
  start.bulge = -1;
  const DieSettings settings =
      schedule_of({press_by(Pressing::upper, StageTarget::density, 0.6)});
  const Trip run(settings, start);
  // What a step of the smallest size could still change.
  EXPECT_NEAR(run.end().mean_density / 0.6, 1, 2 * settings.steps.minimum);
  unsigned landings = 0;
  for (const Step &step : run.steps)
    landings += step.proposal.lands;
  EXPECT_EQ(landings, 2u);
}

TEST(Schedule, ADisplacementIsThatOfEachMovingPunch)
{
  for (const auto who : {Pressing::upper, Pressing::lower, Pressing::both}) {
    const Trip run(
        schedule_of({press_by(who, StageTarget::displacement, 1e-3)}));
    EXPECT_NEAR(run.end().upper_displacement,
                who == Pressing::lower ? 0 : 1e-3,
                rounding * 1e-3);
    EXPECT_NEAR(run.end().lower_displacement,
                who == Pressing::upper ? 0 : 1e-3,
                rounding * 1e-3);
  }
}

TEST(Schedule, ForcesAreMetByLoadingThePunchThatPressed)
{
  for (const auto who : {Pressing::upper, Pressing::lower, Pressing::both}) {
    const Trip run(schedule_of({press_by(who, StageTarget::force, 500.),
                                unload_to(StageTarget::peak_share, 0.02)}));
    EXPECT_NEAR(run.end().peak_force, 500, 500 * 1e-9);
    EXPECT_NEAR(run.end().force[upper_punch], 10, 500 * 1e-9);
    // 7 % of strain at up to 0.5 % a step; 0.4 % of spring-back, steps that
    // grow from 0.025 % until they near the target.
    EXPECT_LE(run.of(0).size(), 22u);
    EXPECT_LE(run.of(1).size(), 12u);
    const unsigned mover = who == Pressing::lower ? lower_punch : upper_punch;
    const unsigned other = who == Pressing::lower ? upper_punch : lower_punch;
    EXPECT_TRUE(run.of(0).back().proposal.motion[mover].loaded);
    for (const Step &step : run.of(1)) {
      EXPECT_EQ(step.proposal.motion[other].displacement, 0);
      EXPECT_LT(step.after.force[upper_punch], step.before.force[upper_punch]);
    }
  }
}

TEST(Schedule, UnloadingToNothingEndsWithAPunchThatIsClear)
{
  for (const Stage &nothing : {unload_to(StageTarget::nothing, 0),
                               unload_to(StageTarget::force, 0),
                               unload_to(StageTarget::peak_share, 0)})
    for (const auto who : {Pressing::upper, Pressing::lower, Pressing::both})
      for (const double power : {1., 1.5}) {
        Press start;
        start.power = power;
        const Trip run(
            schedule_of({press_by(who, StageTarget::density, 0.55), nothing}),
            start);
        EXPECT_EQ(run.end().force[upper_punch], 0);
        EXPECT_GT(run.press.upper - run.press.lower, run.press.natural);
        // As high as it was, and clear of it by less than one per cent.
        EXPECT_LT(run.end().height, 1.01 * run.press.natural);
        EXPECT_LE(run.of(1).size(), 20u);
        for (const Step &step : run.of(1)) {
          EXPECT_FALSE(step.proposal.motion[upper_punch].loaded);
          EXPECT_FALSE(step.proposal.motion[lower_punch].loaded);
          EXPECT_LT(step.after.force[upper_punch],
                    step.before.force[upper_punch]);
        }
      }
}

TEST(Schedule, AFloatingDieFollowsFrictionUntilEjection)
{
  DieSettings settings =
      schedule_of({press_by(Pressing::upper, StageTarget::displacement, 1e-3),
                   {StageKind::hold, StageTarget::displacement, 0, 0, 3},
                   unload_to(StageTarget::peak_share, 0.05),
                   {StageKind::eject, StageTarget::out, 0, 0.05}});
  settings.floating_die = true;
  const Trip run(settings);
  EXPECT_NEAR(run.of(0).back().after.die_displacement, -0.5e-3, 1e-12);
  EXPECT_EQ(run.of(1).size(), 3u);
  for (const Step &step : run.steps) {
    const ToolMotion &die = step.proposal.motion[die_wall];
    EXPECT_EQ(die.loaded, step.stage < 3);
    if (step.stage == 3) {
      EXPECT_EQ(die.displacement, 0);
    }
    // The first guess is what the die does: it follows half of the punch.
    if (step.stage == 0) {
      EXPECT_NEAR(
          die.displacement, -0.5 * step.proposal.driving, 1e-9 * Press::height);
    }
  }
  EXPECT_NEAR(run.end().bottom, run.end().rim, 1e-9 * Press::height);
}

TEST(Schedule, CutStepsGrowAgainAndStillLand)
{
  unsigned asked = 0;
  const Trip run(
      schedule_of({press_by(Pressing::upper, StageTarget::density, 0.6)}),
      {},
      [&](const Proposal &proposal) {
        ++asked;
        return asked > 15 && asked < 25 && proposal.strain > 1.5e-3;
      });
  const StepLimits limits;
  std::size_t cut = 0;
  while (!run.steps.at(cut).was_cut)
    ++cut;
  EXPECT_LE(run.steps[cut].proposal.strain, 1.5e-3);
  EXPECT_DOUBLE_EQ(run.steps[cut + 1].proposal.strain,
                   run.steps[cut].proposal.strain);
  double largest = 0;
  for (std::size_t i = cut; i < run.steps.size(); ++i)
    largest = std::max(largest, run.steps[i].proposal.strain);
  EXPECT_DOUBLE_EQ(largest, limits.maximum);
  EXPECT_NEAR(run.end().mean_density, 0.6, rounding);
}

TEST(Schedule, ALandingThatIsCutLandsLater)
{
  for (const Stage &unloading : {unload_to(StageTarget::peak_share, 0.02),
                                 unload_to(StageTarget::nothing, 0)}) {
    unsigned failures = 3;
    const Trip run(
        schedule_of(
            {press_by(Pressing::both, StageTarget::force, 500.), unloading}),
        {},
        [&](const Proposal &proposal) {
          return proposal.lands && failures > 0 && failures--;
        });
    EXPECT_EQ(failures, 0u);
    EXPECT_NEAR(run.end().peak_force, 500, 500 * 1e-9);
    EXPECT_NEAR(
        run.end().force[upper_punch], 500 * unloading.value, 500 * 1e-9);
  }
}

TEST(Schedule, CutsEndAtTheMinimum)
{
  DieSettings settings =
      schedule_of({press_by(Pressing::upper, StageTarget::density, 0.6)});
  settings.steps.minimum = 2e-4;
  Schedule schedule(settings);
  const Press press;
  schedule.begin_stage(press.state);
  auto proposal = schedule.propose(press.state);
  unsigned cuts = 0;
  while ((proposal = schedule.cut(*proposal, press.state)))
    ++cuts;
  EXPECT_EQ(cuts, 2u); // 1e-3 to 5e-4 to 2.5e-4
}

TEST(Schedule, WhatCannotBeDoneEndsWithASentence)
{
  const auto press = [](StageTarget target, double value) {
    return press_by(Pressing::both, target, value);
  };
  const auto problem = [](const std::vector<Stage> &stages) {
    DieSettings settings;
    settings.stages = stages;
    return Trip(settings).problem;
  };
  const std::pair<std::vector<Stage>, const char *> cases[] = {
      {{press(StageTarget::force, 1e4)}, "is solid"},
      {{press(StageTarget::displacement, 3.5e-3)}, "pass below"},
      {{press(StageTarget::displacement, 3.4e-3)}, "fill height is left"},
      {{press(StageTarget::density, 0.6), press(StageTarget::density, 0.55)},
       "stage 2 cannot be done: it asks for a mean relative density of 0.55"},
      {{press(StageTarget::force, 500), press(StageTarget::force, 400)},
       "bears 500 N already"},
      {{press(StageTarget::force, 500), unload_to(StageTarget::force, 600)},
       "bears only 500 N"}};
  for (const auto &[stages, words] : cases)
    EXPECT_NE(problem(stages).find(words), std::string::npos)
        << words << ": " << problem(stages);
}

TEST(DieSettings, SchedulesThatCannotBeDoneAreRefused)
{
  const auto press = [](StageTarget target, double value) {
    return press_by(Pressing::upper, target, value);
  };
  const double far = 0.6 * DieSettings().geometry.fill_height;
  const std::pair<std::vector<Stage>, const char *> cases[] = {
      {{press(StageTarget::density, 1)}, "density is 1"},
      {{press(StageTarget::force, 0)}, "value is 0"},
      {{press(StageTarget::force, std::nan(""))}, "value is nan"},
      {{press(StageTarget::displacement, 2 * far)}, "pass below"},
      {{press_by(Pressing::both, StageTarget::displacement, far)},
       "pass below"},
      {{press(StageTarget::displacement, far),
        press(StageTarget::displacement, far)},
       "stage 2"},
      {{unload_to(StageTarget::nothing, 0)}, "stage 1 unloads"},
      {{press(StageTarget::out, 0)}, "target"},
      {{{StageKind::hold, StageTarget::force, 0, 0, 0}}, "steps is 0"}};
  for (const auto &[stages, words] : cases)
    try {
      schedule_of(stages);
      ADD_FAILURE() << words;
    } catch (const std::invalid_argument &error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos)
          << error.what();
    }
  DieSettings settings = schedule_of({press(StageTarget::density, 0.6)});
  EXPECT_NO_THROW(settings.check_start(0.59));
  EXPECT_THROW(settings.check_start(0.6), std::invalid_argument);
  settings.floating_die = true;
  EXPECT_NO_THROW(settings.check());
  settings.friction[die_wall] = FrictionCoefficient(0);
  EXPECT_THROW(settings.check(), std::invalid_argument);
}
} // namespace tamp::fem
