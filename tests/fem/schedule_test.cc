// SPDX-License-Identifier: BSD-3-Clause
#include <fem/schedule.h>

#include <cmath>
#include <gtest/gtest.h>

namespace tamp::fem
{
namespace
{
/// A frictionless linear spring between the punches: force = k compression.
struct Spring {
  static constexpr double height = 7e-3, stiffness = 1e6;
  PressState state;

  Spring()
  {
    state.height = state.top = height;
    state.mean_density = 0.5;
  }

  void move(const PunchMotion &motion)
  {
    state.lower_displacement += motion.lower;
    state.upper_displacement =
        motion.upper_is_loaded
            ? motion.upper_force / stiffness - state.lower_displacement
            : state.upper_displacement - motion.upper;
    const double compression =
        state.upper_displacement + state.lower_displacement;
    state.height = height - compression;
    state.top = height - state.upper_displacement;
    state.upper_force = stiffness * compression;
    state.peak_force = std::max(state.peak_force, state.upper_force);
    state.mean_density = 0.5 * height / state.height;
  }
};

/// Runs all stages on the spring; the steps' sizes.
std::vector<double> run(Schedule &schedule, Spring &spring)
{
  std::vector<double> strains;
  while (!schedule.finished()) {
    if (schedule.at_stage_begin())
      schedule.begin_stage(spring.state);
    auto proposal = schedule.propose(spring.state);
    if (!proposal)
      continue;
    Spring trial = spring;
    trial.move(proposal->motion);
    if (const auto loaded = schedule.instead(
            *proposal, spring.state, trial.state.upper_force)) {
      proposal = loaded;
      trial = spring;
      trial.move(loaded->motion);
    }
    schedule.accept(*proposal, spring.state, trial.state, false);
    spring = trial;
    strains.push_back(proposal->strain);
  }
  return strains;
}
} // namespace

TEST(Schedule, StepsGrowToTheMaximumAndLandWithoutSlivers)
{
  StepLimits limits;
  Schedule schedule(
      {{StageKind::press, StageTarget::density, 0.6}}, limits, Spring::height);
  Spring spring;
  const auto strains = run(schedule, spring);
  EXPECT_NEAR(spring.state.mean_density, 0.6, 1e-12);
  EXPECT_DOUBLE_EQ(strains.front(), limits.first);
  for (const double strain : strains) {
    EXPECT_LE(strain, limits.maximum * (1 + 1e-6));
    EXPECT_GE(strain, 0.4 * limits.first);
  }
}

TEST(Schedule, ForcesAreMetByLoadingThePunch)
{
  Schedule schedule({{StageKind::press, StageTarget::force, 500.},
                     {StageKind::unload, StageTarget::peak_share, 0.02}},
                    StepLimits(),
                    Spring::height);
  Spring spring;
  const auto strains = run(schedule, spring);
  EXPECT_NEAR(spring.state.peak_force, 500., 1e-9);
  EXPECT_NEAR(spring.state.upper_force, 10., 1e-9);
  EXPECT_LT(strains.size(), 200u);
}

TEST(Schedule, EjectionKeepsTheLoadAndEndsAtTheRim)
{
  Schedule schedule({{StageKind::press, StageTarget::displacement, 1e-3},
                     {StageKind::eject, StageTarget::rim, 0, 0.05}},
                    StepLimits(),
                    Spring::height);
  Spring spring;
  run(schedule, spring);
  EXPECT_NEAR(spring.state.upper_force, 0.05 * spring.state.peak_force, 1e-9);
  EXPECT_NEAR(spring.state.top, Spring::height, 1e-6 * Spring::height);
}

TEST(Schedule, CutsEndAtTheMinimum)
{
  StepLimits limits;
  limits.minimum = 2e-4;
  Schedule schedule(
      {{StageKind::press, StageTarget::density, 0.6}}, limits, Spring::height);
  const Spring spring;
  schedule.begin_stage(spring.state);
  auto proposal = schedule.propose(spring.state);
  unsigned cuts = 0;
  while ((proposal = schedule.cut(*proposal, spring.state)))
    ++cuts;
  EXPECT_EQ(cuts, 2u); // 1e-3 to 5e-4 to 2.5e-4
}
} // namespace tamp::fem
