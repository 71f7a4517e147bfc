// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/elastic.h>
#include <fem/path_driver.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace tamp::fem
{
namespace
{
using Control = ComponentTarget::Control;
using Tensor = dealii::Tensor<2, 3>;

constexpr double E = 1e9, nu = 0.25;

ContinuumPoints<Elastic> elastic_points(const std::size_t size = 1)
{
  ElasticParameters parameters;
  parameters.elasticity = {E, nu};
  return {Elastic(parameters), size};
}

ContinuumPoints<DruckerPragerCap> cap_points()
{
  return {DruckerPragerCap(), 1};
}

struct Log {
  std::vector<PathRecord> records;
  std::vector<unsigned> stages;
  PathEnd end = PathEnd::not_converged;
};

Log drive(MaterialPoints &points,
          const std::vector<PathStage> &stages,
          const double tolerance = 1e-3)
{
  Log log;
  log.end = drive_path(
      points,
      stages,
      [&](const unsigned stage) { log.stages.push_back(stage); },
      [&](const PathRecord &record) { log.records.push_back(record); },
      tolerance);
  return log;
}

PathStage press(const double axial, const double increment = 1e-3)
{
  PathStage stage;
  stage.components[2].value = axial;
  stage.maximum_increment = increment;
  return stage;
}

/// Lateral stress held at a value while the axial strain goes on.
PathStage triaxial(const double axial, const double lateral_stress)
{
  PathStage stage = press(axial);
  stage.components[0] = {Control::stress, lateral_stress, false};
  stage.components[1] = {Control::stress, lateral_stress, false};
  return stage;
}

TEST(PathDriver, StrainStageTakesEqualSteps)
{
  auto points = elastic_points();
  const Log log = drive(points, {press(-0.01), press(-0.02, 5e-3)});
  EXPECT_EQ(log.end, PathEnd::finished);
  EXPECT_EQ(log.stages, (std::vector<unsigned>{0, 1}));
  ASSERT_EQ(log.records.size(), 1u + 10 + 2);
  EXPECT_EQ(log.records.back().step, 12u);
  EXPECT_EQ(log.records.back().stage, 1u);
  for (unsigned i = 0; i <= 10; ++i)
    EXPECT_NEAR(log.records[i].F[2][2], std::exp(-1e-3 * i), 1e-14);
  EXPECT_DOUBLE_EQ(log.records.back().F[2][2], std::exp(-0.02));
  EXPECT_EQ(log.records.back().F[0][0], 1);
}

TEST(PathDriver, RelativeTargetsCountFromTheStage)
{
  auto points = elastic_points();
  PathStage more = press(-0.01);
  more.components[2].relative = true;
  const Log log = drive(points, {press(-0.01), more, more});
  EXPECT_NEAR(log.records.back().F[2][2], std::exp(-0.03), 1e-14);
}

TEST(PathDriver, DiagonalPathsStayExactlyDiagonal)
{
  auto points = cap_points();
  PathStage stage = press(-0.3);
  stage.components[0].value = -0.1;
  const Log log = drive(points, {stage});
  for (const PathRecord &record : log.records)
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = i + 1; j < 3; ++j) {
        EXPECT_EQ(record.F[i][j], 0);
        EXPECT_EQ(record.response.stress[i][j], 0);
      }
}

TEST(PathDriver, ShearStrainIsSymmetricStretch)
{
  auto points = elastic_points();
  PathStage stage;
  stage.components[3].value = 0.05;
  stage.components[0].value = -0.02;
  const Log log = drive(points, {stage});
  const auto &last = log.records.back();
  EXPECT_NEAR(last.F[1][2], std::sinh(0.05), 1e-14);
  EXPECT_NEAR(last.F[2][2], std::cosh(0.05), 1e-14);
  // The axes stand still: Hencky's law.
  EXPECT_NEAR(last.response.stress[1][2], E / (1 + nu) * 0.05, 1e-6 * E);
}

TEST(PathDriver, SimpleCompressionHasYoungsModulus)
{
  auto points = elastic_points();
  const Log log = drive(points, {triaxial(-0.02, 0)}, 1e-9);
  ASSERT_EQ(log.end, PathEnd::finished);
  for (const PathRecord &record : log.records) {
    EXPECT_NEAR(record.response.stress[2][2],
                E * std::log(record.F[2][2]),
                1e-8 * E * 0.02);
    EXPECT_NEAR(std::log(record.F[0][0]), -nu * std::log(record.F[2][2]), 1e-9);
  }
}

TEST(PathDriver, MeanStressIsHeldWhileTheAxisIsStrained)
{
  auto points = elastic_points();
  PathStage stage = press(-0.01);
  stage.axial_share = 0.5;
  for (const unsigned i : {0u, 1u})
    stage.components[i] = {Control::stress, 1.5 * -2e6, false};
  for (const bool deviatoric : {false, true}) {
    stage.deviatoric = deviatoric;
    stage.components[2].relative = true;
    const Log log = drive(points, {stage}, 1e-9);
    ASSERT_EQ(log.end, PathEnd::finished);
    const auto &last = log.records.back();
    EXPECT_NEAR(trace(last.response.stress) / 3, -2e6, 1e-8 * E * 0.01);
    const double axial = std::log(last.F[2][2]),
                 lateral = std::log(last.F[0][0]);
    EXPECT_NEAR(deviatoric ? axial - lateral : axial, -0.01, 1e-9);
  }
}

TEST(PathDriver, AStageEndsWhenItHasEnough)
{
  auto points = elastic_points();
  PathStage stage = press(-0.01);
  unsigned asked = 0;
  stage.enough = [&] { return ++asked == 4; };
  const Log log = drive(points, {stage, press(-0.01)});
  EXPECT_EQ(log.end, PathEnd::finished);
  EXPECT_NEAR(log.records.at(4).F[2][2], std::exp(-4e-3), 1e-14);
  EXPECT_EQ(log.records.at(4).stage, 0u);
  EXPECT_EQ(log.records.at(5).stage, 1u);
}

TEST(PathDriver, AllStressesCanBePrescribed)
{
  auto points = elastic_points();
  PathStage stage;
  const std::array<double, 6> target{-5e6, -6e6, -9e6, 1e6, -2e6, 5e5};
  for (unsigned i = 0; i < 6; ++i)
    stage.components[i] = {Control::stress, target[i], false};
  stage.minimum_steps = 4;
  const Log log = drive(points, {stage}, 1e-6);
  ASSERT_EQ(log.end, PathEnd::finished);
  const auto &stress = log.records.back().response.stress;
  EXPECT_NEAR(stress[0][0], target[0], 10);
  EXPECT_NEAR(stress[1][1], target[1], 10);
  EXPECT_NEAR(stress[2][2], target[2], 10);
  EXPECT_NEAR(stress[1][2], target[3], 10);
  EXPECT_NEAR(stress[0][2], target[4], 10);
  EXPECT_NEAR(stress[0][1], target[5], 10);
}

TEST(PathDriver, PlasticTriaxialPathHoldsTheLateralStress)
{
  auto points = cap_points();
  PathStage isotropic = press(-0.1);
  isotropic.components[0].value = isotropic.components[1].value = -0.1;
  const Log first = drive(points, {isotropic});
  const double pressure = first.records.back().response.stress[0][0];
  // A driver starts anew where the point is.
  const Log log = drive(points, {triaxial(-0.2, pressure)});
  ASSERT_EQ(log.end, PathEnd::finished);
  for (const PathRecord &record : log.records) {
    const auto &stress = record.response.stress;
    EXPECT_NEAR(stress[0][0], pressure, 1.1e-3 * std::abs(stress[2][2]));
    EXPECT_EQ(record.response.status, Status::converged);
  }
}

TEST(PathDriver, StressReleaseTakesAsManyStepsAsItNeeds)
{
  auto points = cap_points();
  PathStage release;
  for (unsigned i = 0; i < 3; ++i)
    release.components[i] = {Control::stress, 0, false};
  release.maximum_increment = 1e-3;
  const Log log = drive(points, {press(-0.6, 5e-3), release});
  ASSERT_EQ(log.end, PathEnd::finished);
  // The scale of the tolerance is the largest stress that is left.
  EXPECT_LT(log.records.back().response.stress.norm(), 1e4);
  for (std::size_t i = 122; i < log.records.size(); ++i)
    EXPECT_LT(
        std::abs(std::log(log.records[i].F[2][2] / log.records[i - 1].F[2][2])),
        1.6e-3);
}

TEST(PathDriver, StageEndsAtTheStressItWaitsFor)
{
  auto points = cap_points();
  PathStage load = press(-1.0, 0.02);
  load.has_until = true;
  load.until_stress = -50e6;
  load.until_above = false;
  PathStage unload = press(0, 5e-3);
  unload.has_until = true;
  unload.until_stress = -5e6;
  const Log log = drive(points, {load, unload});
  ASSERT_EQ(log.end, PathEnd::finished);
  double end_of_load = 0;
  for (const PathRecord &record : log.records)
    if (record.stage == 0)
      end_of_load = record.response.stress[2][2];
  EXPECT_NEAR(end_of_load, -50e6, 0.5e6);
  EXPECT_NEAR(log.records.back().response.stress[2][2], -5e6, 0.05e6);
}

TEST(PathDriver, StageThatIsAlreadyThereTakesNoStep)
{
  auto points = elastic_points();
  PathStage stage = press(0.01);
  stage.has_until = true;
  stage.until_stress = -1;
  const Log log = drive(points, {stage});
  EXPECT_EQ(log.end, PathEnd::finished);
  EXPECT_EQ(log.records.size(), 1u);
}

TEST(PathDriver, OtherPointsStandStill)
{
  auto points = elastic_points(3);
  drive(points, {press(-0.01)});
  EXPECT_LT(points.state(0).stress[2][2], 0);
  EXPECT_EQ(points.state(2).stress.norm(), 0);
  EXPECT_EQ(points.state(2).relative_density,
            points.law().initial_state().relative_density);
}

/// Fails for increments above a size; else elastic.
class Brittle final : public MaterialPoints
{
public:
  explicit Brittle(const double largest) : largest_(largest) {}
  std::size_t size() const override { return 1; }
  void evaluate(std::span<const Deformation> deformations,
                const Want want,
                std::span<Response> responses) override
  {
    points_.evaluate(deformations, want, responses);
    const auto &F = deformations[0].relative_F;
    if (std::abs(F[2][2] - 1) > largest_)
      responses[0].status = Status::failed;
  }
  void commit() override { points_.commit(); }
  void pack(std::size_t, std::vector<char> &) const override {}
  void unpack(std::size_t, std::span<const char>) override {}
  double cost(std::size_t) const override { return 0; }

private:
  double largest_;
  ContinuumPoints<Elastic> points_ = elastic_points();
};

TEST(PathDriver, FailureCutsTheIncrement)
{
  Brittle points(3e-3);
  const Log log = drive(points, {press(-0.02, 1e-2)});
  EXPECT_EQ(log.end, PathEnd::finished);
  EXPECT_GE(log.records.size(), 8u);
  EXPECT_DOUBLE_EQ(log.records.back().F[2][2], std::exp(-0.02));
  EXPECT_NEAR(log.records.back().response.stress[2][2],
              -0.02 * E * (1 - nu) / (1 + nu) / (1 - 2 * nu),
              1e-8 * E);
}

TEST(PathDriver, GivesUpAfterTooManyCuts)
{
  Brittle points(1e-6);
  const Log log = drive(points, {press(-0.02, 1e-2)});
  EXPECT_EQ(log.end, PathEnd::not_converged);
  EXPECT_EQ(log.records.size(), 1u);
}

TEST(PathDriver, GradientsAreTakenAsTheyAre)
{
  auto points = elastic_points();
  PathStage stage;
  auto &gradients = stage.gradients;
  gradients.assign(2, Tensor(dealii::unit_symmetric_tensor<3>()));
  gradients[0][0][1] = 0.1;
  gradients[1][0][1] = 0.1;
  gradients[1][2][2] = 0.97;
  Log log = drive(points, {stage});
  EXPECT_EQ(log.end, PathEnd::finished);
  const auto &records = log.records;
  ASSERT_EQ(records.size(), 3u);
  for (unsigned i = 0; i < 3; ++i) // products with a unit tensor
    for (unsigned j = 0; j < 3; ++j)
      EXPECT_EQ(records[2].F[i][j], gradients[1][i][j]);
  EXPECT_NEAR(records[2].response.relative_density, 0.6 / 0.97, 1e-12);
  gradients[1][2][2] = -1;
  EXPECT_EQ(drive(points, {stage}).end, PathEnd::not_converged);
}

TEST(PathDriver, GradientsCountFromTheStartOfTheirStage)
{
  auto points = elastic_points();
  PathStage shear;
  shear.gradients.assign(1, Tensor(dealii::unit_symmetric_tensor<3>()));
  shear.gradients[0][0][2] = 0.2;
  const Log log = drive(points, {press(-0.01), shear, shear});
  ASSERT_EQ(log.end, PathEnd::finished);
  const Tensor &F = log.records.back().F;
  // Shears add up; the height is that of the compression before, to round-off.
  EXPECT_NEAR(F[0][2], 0.4 * std::exp(-0.01), 1e-14);
  EXPECT_NEAR(F[2][2], std::exp(-0.01), 1e-14);
}

TEST(PathDriver, ComponentsKeepTheRotationOfTheGradients)
{
  // A quarter turn, then compression along z, then back.
  auto points = elastic_points();
  PathStage turn, back;
  for (const double angle : {0.5, 1.0}) {
    Tensor Q(dealii::unit_symmetric_tensor<3>());
    Q[0][0] = Q[2][2] = std::cos(angle * std::numbers::pi / 2);
    Q[0][2] = std::sin(angle * std::numbers::pi / 2);
    Q[2][0] = -Q[0][2];
    turn.gradients.push_back(Q);
    back.gradients.push_back(transpose(Q));
  }
  const Log log = drive(points, {turn, press(-0.01), back});
  ASSERT_EQ(log.end, PathEnd::finished);
  const PathRecord &pressed = log.records[log.records.size() - 3];
  EXPECT_NEAR(pressed.F[2][0], -std::exp(-0.01), 1e-14); // z was -x
  const auto &stress = log.records.back().response.stress;
  // What was pressed along z now stands along x, to round-off of the turns.
  EXPECT_NEAR(stress[0][0], pressed.response.stress[2][2], 1e-6 * E * 0.01);
  EXPECT_NEAR(stress[2][2], pressed.response.stress[0][0], 1e-6 * E * 0.01);
}

TEST(PathDriver, SimpleShearOfAnElasticSolidHasItsModulus)
{
  auto points = elastic_points();
  PathStage shear;
  for (unsigned i = 1; i <= 10; ++i) {
    shear.gradients.emplace_back(dealii::unit_symmetric_tensor<3>());
    shear.gradients.back()[0][2] = 1e-4 * i;
  }
  const Log log = drive(points, {shear});
  ASSERT_EQ(log.records.size(), 11u);
  // G gamma, to second order in gamma.
  EXPECT_NEAR(log.records.back().response.stress[0][2],
              E / (2 * (1 + nu)) * 1e-3,
              1e-3 * E / (2 * (1 + nu)) * 1e-3);
}

TEST(PathDriver, AGradientThatFailsIsCut)
{
  Brittle points(6e-3);
  PathStage stage;
  stage.gradients.emplace_back(dealii::unit_symmetric_tensor<3>());
  stage.gradients[0][2][2] = 0.98;
  const Log log = drive(points, {stage});
  EXPECT_EQ(log.end, PathEnd::finished);
  EXPECT_EQ(log.records.size(), 1u + 4);
  EXPECT_EQ(log.records.back().F[2][2], 0.98);
}
} // namespace
} // namespace tamp::fem
