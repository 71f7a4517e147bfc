// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/elastic.h>
#include <tests/fem/test_points.h>

#include <cmath>
#include <gtest/gtest.h>

namespace tamp::fem
{
namespace
{
using test::HenckyLaw;
using test::HenckyPoints;

/// Poisson's ratio 0.2: k = nu / (1 - nu) = 1/4 at small strain.
HenckyLaw soft_law()
{
  HenckyLaw law;
  law.mu = 4e8;
  law.lambda = 2 * law.mu * 0.2 / (1 - 2 * 0.2);
  return law;
}

DieSettings default_settings()
{
  DieSettings settings;
  settings.geometry.radial_elements = 3;
  settings.geometry.axial_elements = 4;
  settings.solver.force_tolerance = 1e-8;
  settings.solver.displacement_tolerance = 1e-8;
  return settings;
}

Stage press_to_density(double density)
{
  return {StageKind::press, StageTarget::density, density, 0.05, 1};
}

/// A model with what it borrows.
struct Trip {
  DieSettings settings;
  Mesh mesh;
  HenckyPoints points;
  DieModel model;
  std::vector<StepRecord> records;

  explicit Trip(const DieSettings &chosen, const HenckyLaw &law = soft_law())
      : settings(chosen), mesh(build_mesh(chosen.geometry)),
        points(mesh.number_of_points(), law), model(settings, mesh, points)
  {
  }

  Advance finish()
  {
    while (true) {
      const Advance advance = model.advance();
      if (advance != Advance::stepped)
        return advance;
      records.push_back(model.last_step());
    }
  }
};

double balance_error(const StepRecord &record)
{
  return std::abs(record.upper_force - record.lower_force -
                  record.wall_friction_force) /
         (std::abs(record.upper_force) + std::abs(record.lower_force));
}
} // namespace

TEST(DieModel, FrictionlessPressingIsUniformAndFollowsTheLaw)
{
  for (const NonlinearMethod method :
       {NonlinearMethod::newton, NonlinearMethod::anderson}) {
    DieSettings settings = default_settings();
    settings.friction[die_wall] = FrictionCoefficient(0);
    settings.solver.method = method;
    settings.stages = {press_to_density(0.6)};
    Trip run(settings);
    ASSERT_EQ(run.finish(), Advance::finished);
    dealii::Tensor<2, 3> F;
    F[0][0] = F[1][1] = 1;
    F[2][2] = 0.5 / 0.6;
    const auto expected = soft_law().stress(F);
    for (const Response &response : run.model.responses())
      EXPECT_LT((response.stress - expected).norm(), 1e-7 * expected.norm());
    EXPECT_NEAR(expected[0][0] / expected[2][2], 0.25, 1e-12);
    const StepRecord &last = run.records.back();
    EXPECT_NEAR(last.upper_force / last.punch_area / -expected[2][2], 1, 1e-7);
    EXPECT_NEAR(
        last.wall_normal_force / last.wall_area / -expected[0][0], 1, 1e-7);
    EXPECT_NEAR(last.mean_relative_density, 0.6, 1e-12);
    EXPECT_NEAR(last.stage_progress, 1, 1e-12);
    for (const auto &gradient : run.model.deformation_gradients())
      EXPECT_NEAR(gradient[2][2], 0.5 / 0.6, 1e-8);
  }
}

TEST(DieModel, ForcesBalanceInEveryStepWithFriction)
{
  DieSettings settings = default_settings();
  settings.stages = {press_to_density(0.6)};
  HenckyLaw law = soft_law();
  law.stiffening = 5;
  Trip run(settings, law);
  ASSERT_EQ(run.finish(), Advance::finished);
  for (const StepRecord &record : run.records) {
    // All forces but the residual's cancel.
    EXPECT_LT(balance_error(record), 10 * settings.solver.force_tolerance);
    EXPECT_GT(record.wall_friction_force, 0);
    EXPECT_LE(record.wall_friction_force, 0.2 * record.wall_normal_force);
    EXPECT_EQ(record.cuts, 0u);
  }
}

TEST(DieModel, PressesUnloadsAndEjects)
{
  DieSettings settings = default_settings();
  settings.stages = {press_to_density(0.55),
                     {StageKind::unload, StageTarget::peak_share, 0.1},
                     {StageKind::eject, StageTarget::rim, 0, 0.05}};
  settings.steps.unloading = 5e-3;
  Trip run(settings);
  ASSERT_EQ(run.finish(), Advance::finished) << run.model.failure().reason;
  double peak = 0;
  for (const StepRecord &record : run.records) {
    peak = std::max(peak, record.upper_force);
    EXPECT_LT(balance_error(record), 1e-6);
  }
  for (std::size_t i = 0; i + 1 < run.records.size(); ++i)
    if (run.records[i].stage == 1 && run.records[i + 1].stage == 2) {
      EXPECT_NEAR(run.records[i].upper_force / peak, 0.1, 1e-6);
    }
  const StepRecord &last = run.records.back();
  EXPECT_NEAR(last.upper_force / peak, 0.05, 1e-6);
  EXPECT_LT(last.wall_friction_force, 0);
  EXPECT_NEAR(last.wall_friction_force / last.wall_normal_force, -0.2, 1e-6);
  EXPECT_NEAR(
      last.upper_displacement, 0, 2e-5 * run.settings.geometry.fill_height);
  EXPECT_GT(last.lower_displacement, 0);
}

TEST(DieModel, PressesToAForceAndHolds)
{
  DieSettings settings = default_settings();
  settings.stages = {{StageKind::press, StageTarget::force, 5e3},
                     {StageKind::hold, StageTarget::force, 0, 0.05, 2}};
  Trip run(settings);
  ASSERT_EQ(run.finish(), Advance::finished) << run.model.failure().reason;
  EXPECT_NEAR(run.records.back().upper_force, 5e3, 0.1);
  EXPECT_EQ(run.records.back().stage, 1u);
  EXPECT_NEAR(run.records[run.records.size() - 3].upper_force, 5e3, 1e-3);
}

TEST(DieModel, TellsWhenStagesBegin)
{
  DieSettings settings = default_settings();
  settings.stages = {press_to_density(0.51),
                     {StageKind::unload, StageTarget::peak_share, 0.5}};
  const Mesh mesh = build_mesh(settings.geometry);
  HenckyPoints points(mesh.number_of_points(), soft_law());
  std::vector<double> peaks;
  DieModel model(settings, mesh, points, [&](unsigned stage, double peak) {
    EXPECT_EQ(stage, peaks.size());
    peaks.push_back(peak);
  });
  double upper = 0, area = 1;
  while (model.advance() == Advance::stepped)
    if (model.last_step().stage == 0) {
      upper = model.last_step().upper_force;
      area = model.last_step().punch_area;
    }
  ASSERT_EQ(peaks.size(), 2u);
  EXPECT_EQ(peaks[0], 0);
  EXPECT_DOUBLE_EQ(peaks[1], upper / area);
}

TEST(DieModel, FailureNamesThePointAndKeepsTheLastState)
{
  DieSettings settings = default_settings();
  settings.stages = {press_to_density(0.6)};
  Trip run(settings);
  const std::size_t bad = 17;
  run.points.spoil = [&](unsigned, std::span<Response> responses) {
    if (responses[bad].relative_density > 0.52)
      responses[bad].status = Status::failed;
  };
  ASSERT_EQ(run.finish(), Advance::failed);
  const Failure &failure = run.model.failure();
  EXPECT_EQ(failure.point, bad);
  EXPECT_NE(failure.reason.find("a material point failed"), std::string::npos)
      << failure.reason;
  EXPECT_LT((failure.position - run.model.point_positions()[bad]).norm(),
            1e-12);
  EXPECT_LT(failure.stress[2][2], 0);
  // The state is the last accepted one, in the model and in the points.
  EXPECT_EQ(run.points.commits, run.records.size());
  EXPECT_FALSE(run.points.committed_spoilt);
  for (std::size_t point = 0; point < run.points.size(); ++point) {
    EXPECT_LT((run.points.committed()[point] -
               run.model.deformation_gradients()[point])
                  .norm(),
              1e-13);
    EXPECT_LE(run.model.responses()[point].relative_density, 0.53);
  }
  EXPECT_EQ(run.model.last_step().step, run.records.size());
}

TEST(DieModel, StepThatFailsOnceIsCutAndTheRunGoesOn)
{
  DieSettings settings = default_settings();
  settings.stages = {press_to_density(0.53)};
  Trip run(settings);
  run.points.spoil = [](unsigned evaluation, std::span<Response> responses) {
    if (evaluation == 9)
      responses[3].status = Status::failed;
  };
  ASSERT_EQ(run.finish(), Advance::finished);
  unsigned cuts = 0, updates = 1; // one of the start
  for (const StepRecord &record : run.records) {
    cuts += record.cuts;
    updates += record.material_updates;
    EXPECT_GE(record.material_updates, record.iterations);
  }
  EXPECT_EQ(cuts, 1u);
  EXPECT_EQ(updates, run.points.evaluations);
  EXPECT_EQ(run.points.commits, run.records.size());
  EXPECT_FALSE(run.points.committed_spoilt);
  EXPECT_NEAR(run.records.back().mean_relative_density, 0.53, 1e-12);
}

TEST(DieModel, ToolsHoldTheStressThatThePowderBrings)
{
  DieSettings settings = default_settings();
  settings.stages = {press_to_density(0.7)};
  ElasticParameters parameters;
  for (unsigned i = 0; i < 3; ++i)
    parameters.initial_stress[i][i] = -0.5e6;
  const Mesh mesh = build_mesh(settings.geometry);
  ContinuumPoints<Elastic> points(Elastic(parameters), mesh.number_of_points());
  const DieModel model(settings, mesh, points);
  const StepRecord &start = model.last_step();
  EXPECT_EQ(start.step, 0u);
  // Round-off of sums over nodes.
  EXPECT_NEAR(start.upper_force / start.punch_area / 0.5e6, 1, 1e-12);
  EXPECT_NEAR(start.lower_force / start.punch_area / 0.5e6, 1, 1e-12);
  EXPECT_NEAR(start.wall_normal_force / start.wall_area / 0.5e6, 1, 1e-12);
}

TEST(DieModel, ImpossibleSizesAreRefused)
{
  const DieSettings settings = default_settings();
  const Mesh mesh = build_mesh(settings.geometry);
  HenckyPoints points(3, soft_law());
  EXPECT_THROW(DieModel(settings, mesh, points), std::invalid_argument);
}
} // namespace tamp::fem
