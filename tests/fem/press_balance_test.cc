// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/drucker_prager_cap.h>
#include <tests/fem/die_run.h>

#include <algorithm>
#include <cmath>

namespace tamp::fem
{
namespace
{
using namespace test;

/// Cellulose in a small die with friction on all tools.
DieSettings rough_die()
{
  DieSettings settings = frictionless_die(3, 4);
  settings.friction.fill(FrictionCoefficient(0.2));
  settings.friction[die_wall] = FrictionCoefficient(0.3);
  return settings;
}

Stage press_by(Pressing who, double displacement)
{
  Stage stage = press_down(displacement);
  stage.pressing = who;
  return stage;
}

using CapRun = DieRun<DruckerPragerCap>;

/// Largest force that is left over of the tools, as a share of the punches', or
/// of 1e-4 of their largest so far.
double worst_balance(const std::vector<StepRecord> &records)
{
  double worst = 0, peak = 0;
  for (const StepRecord &record : records) {
    const double punches =
        std::max(std::abs(record.upper_force), std::abs(record.lower_force));
    peak = std::max(peak, punches);
    worst = std::max(worst,
                     std::abs(record.upper_force - record.lower_force -
                              record.wall_friction_force) /
                         std::max(punches, 1e-4 * peak));
  }
  return worst;
}
constexpr double balanced = 1e-8;

/// Two runs take the same way but for what Newton leaves over.
constexpr double alike = 1e-6;

/// Density of the point at a place, of the nearest one.
double density_at(const CapRun &run, const dealii::Tensor<1, 3> &place)
{
  const auto places = run.model.point_positions();
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    if ((places[i] - place).norm() < (places[nearest] - place).norm())
      nearest = i;
  EXPECT_LT((places[nearest] - place).norm(),
            alike * run.settings.geometry.fill_height);
  return run.model.responses()[nearest].relative_density;
}

/// The densities of `run` are those of `other` seen upside down; the compacts'
/// middles are at these heights.
void expect_mirrored(const CapRun &run,
                     double middle,
                     const CapRun &other,
                     double other_middle)
{
  const auto places = run.model.point_positions();
  double spread = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double density = run.model.responses()[i].relative_density;
    dealii::Tensor<1, 3> place = places[i];
    place[2] = other_middle - (place[2] - middle);
    EXPECT_NEAR(density, density_at(other, place), alike);
    spread = std::max(
        spread, std::abs(density - run.model.responses()[0].relative_density));
  }
  EXPECT_GT(spread, 5e-3); // not uniform: there is something to mirror
}
} // namespace

class PressBalance : public testing::TestWithParam<Ejection>
{
};
INSTANTIATE_TEST_SUITE_P(DieModel,
                         PressBalance,
                         testing::Values(Ejection::push, Ejection::withdrawal));

TEST_P(PressBalance, HoldsInEveryStepUntilNoForceIsLeft)
{
  DieSettings settings = rough_die();
  settings.stages = {press_by(Pressing::upper, 2e-3),
                     {StageKind::unload, StageTarget::peak_share, 0.1},
                     {StageKind::eject, StageTarget::out, 0, 0}};
  settings.stages.back().ejection = GetParam();
  const CapRun run(settings, DruckerPragerCap());
  EXPECT_LT(worst_balance(run.records), balanced);
  const StepRecord &last = run.last();
  const double peak = run.of(0).back().upper_force;
  EXPECT_NEAR(last.upper_force, 0, balanced * peak);
  EXPECT_NEAR(last.lower_force, 0, balanced * peak);
  EXPECT_NEAR(last.wall_friction_force, 0, balanced * peak);
  EXPECT_NEAR(last.wall_normal_force, 0, balanced * peak);
  // It has sprung back.
  EXPECT_GT(last.compact_radius, 1.001 * settings.geometry.radius);
  EXPECT_GT(last.compact_height, run.of(0).back().compact_height);
}

TEST(DieModel, WithdrawalEjectsLikePushing)
{
  std::vector<StepRecord> records[2];
  for (const Ejection ejection : {Ejection::push, Ejection::withdrawal}) {
    DieSettings settings = rough_die();
    settings.stages = {press_by(Pressing::upper, 1e-3),
                       {StageKind::eject, StageTarget::displacement, 1e-3, 0}};
    settings.stages.back().ejection = ejection;
    const CapRun run(settings, DruckerPragerCap());
    EXPECT_EQ(run.last().lower_displacement > 0, ejection == Ejection::push);
    records[ejection == Ejection::push ? 0 : 1] = run.records;
  }
  ASSERT_EQ(records[0].size(), records[1].size());
  double peak = 0;
  for (std::size_t i = 0; i < records[0].size(); ++i) {
    const StepRecord &push = records[0][i], &draw = records[1][i];
    peak = std::max(peak, push.upper_force);
    EXPECT_NEAR(push.lower_force, draw.lower_force, alike * peak);
    EXPECT_NEAR(push.wall_normal_force, draw.wall_normal_force, alike * peak);
    EXPECT_NEAR(
        push.wall_friction_force, draw.wall_friction_force, alike * peak);
  }
}

TEST(DieModel, DoubleActionIsSymmetricAboutTheMiddle)
{
  DieSettings settings = rough_die();
  settings.stages = {press_by(Pressing::both, 1e-3)};
  const CapRun run(settings, DruckerPragerCap());
  EXPECT_LT(worst_balance(run.records), balanced);
  const StepRecord &last = run.last();
  EXPECT_NEAR(last.lower_force / last.upper_force, 1, balanced);
  EXPECT_NEAR(last.wall_friction_force / last.upper_force, 0, balanced);
  EXPECT_DOUBLE_EQ(last.upper_displacement, last.lower_displacement);
  const double middle = 0.5 * settings.geometry.fill_height;
  expect_mirrored(run, middle, run, middle);
}

TEST(DieModel, LowerPressingIsUpperPressingUpsideDown)
{
  DieSettings settings = rough_die();
  settings.stages = {press_by(Pressing::upper, 1e-3)};
  const CapRun upper(settings, DruckerPragerCap());
  settings.stages = {press_by(Pressing::lower, 1e-3)};
  const CapRun lower(settings, DruckerPragerCap());
  ASSERT_EQ(upper.records.size(), lower.records.size());
  EXPECT_LT(worst_balance(lower.records), balanced);
  for (std::size_t i = 0; i < upper.records.size(); ++i) {
    const StepRecord &a = upper.records[i], &b = lower.records[i];
    EXPECT_NEAR(a.upper_force, b.lower_force, alike * a.upper_force);
    EXPECT_NEAR(a.lower_force, b.upper_force, alike * a.upper_force);
    EXPECT_NEAR(
        a.wall_friction_force, -b.wall_friction_force, alike * a.upper_force);
  }
  const double middle = 0.5 * settings.geometry.fill_height;
  expect_mirrored(upper, middle - 0.5e-3, lower, middle + 0.5e-3);
}

TEST(DieModel, FloatingDieIsDoubleActionSeenFromTheDie)
{
  DieSettings settings = rough_die();
  settings.stages = {press_by(Pressing::both, 0.5e-3)};
  const CapRun both(settings, DruckerPragerCap());
  settings.stages = {press_by(Pressing::upper, 1e-3)};
  settings.floating_die = true;
  const CapRun floating(settings, DruckerPragerCap());
  EXPECT_LT(worst_balance(floating.records), balanced);
  // Nothing carries the die.
  for (const StepRecord &record : floating.records)
    EXPECT_NEAR(record.wall_friction_force, 0, balanced * record.upper_force);
  EXPECT_NEAR(floating.last().upper_force / both.last().upper_force, 1, alike);
  const auto here = both.model.point_positions();
  const auto there = floating.model.point_positions();
  for (std::size_t i = 0; i < here.size(); ++i) {
    EXPECT_NEAR(there[i][0], here[i][0], alike * 1e-3);
    EXPECT_NEAR(there[i][2], here[i][2] - 0.5e-3, alike * 1e-3);
    EXPECT_NEAR(floating.model.responses()[i].relative_density,
                both.model.responses()[i].relative_density,
                alike);
  }
}
} // namespace tamp::fem
