// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/fkm_gurson.h>
#include <fem/laws/modified_cam_clay.h>
#include <fem/yield_branch.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace tamp::fem
{
namespace
{
using Kind = BranchKind;

constexpr double offset = 5e-4;
// Moduli are those of pressures lower by K times this. Cam-Clay's strains are
// elastic to 8 % of strain, and its K is 20 times the pressure: the offset is
// then uncertain by 2e-5.
constexpr double small = 1e-5;
// Of prescribed stresses over the pressure; those of a path are met within it.
constexpr double stress_tolerance = 1e-4;

BranchDriving driving()
{
  BranchDriving driving;
  driving.stress_tolerance = stress_tolerance;
  driving.increment = 5e-5; // an offset is many: no chord across a peak
  return driving;
}

/// A point of a law that was compressed isotropically.
template <class Law>
struct Powder {
  Law law;
  ContinuumPoints<Law> points;
  double pressure = 0, density = 0; ///< reached
  std::vector<char> state;
  MeasuredModuli moduli; ///< there

  Powder(const Law &made, const double reach) : law(made), points(made, 1)
  {
    PathStage stage;
    for (unsigned i = 0; i < 3; ++i)
      stage.components[i].value =
          -std::log(reach / law.parameters().initial_relative_density) / 3;
    EXPECT_EQ(drive_path(points,
                         {stage},
                         {},
                         [&](const PathRecord &record) {
                           pressure = -trace(record.response.stress) / 3;
                           density = record.response.relative_density;
                         }),
              PathEnd::finished);
    points.pack(0, state);
    moduli = measure_moduli(points, small).value();
  }

  typename Law::State reached() const { return points.state(0); }

  /// Yields after it was unloaded to a share of the pressure.
  std::map<YieldCriterion, YieldPoint> yield(const Kind kind,
                                             const double share)
  {
    points.unpack(0, state);
    std::vector<MeasuredModuli> measured{moduli};
    for (double now = 0.8; now > share; now -= 0.2) {
      EXPECT_EQ(unload_to(points, now * pressure, driving()),
                PathEnd::finished);
      measured.push_back(measure_moduli(points, small).value());
    }
    EXPECT_EQ(unload_to(points, share * pressure, driving()),
              PathEnd::finished);
    measured.push_back(measure_moduli(points, small).value());
    const ModuliOverPressure over_pressure(measured);
    const BranchEnd end = drive_branch(
        points, kind, {offset, offset * pressure}, over_pressure, driving());
    EXPECT_EQ(end.end, PathEnd::finished);
    std::map<YieldCriterion, YieldPoint> found;
    for (const YieldPoint &point : end.points)
      found[point.criterion] = point;
    return found;
  }
};

/// Branches that meet the cap and the shear line.
const std::vector<std::pair<Kind, double>> branches{{Kind::compression, 0.9},
                                                    {Kind::compression, 0.6},
                                                    {Kind::compression, 0.3},
                                                    {Kind::compression, 0.1},
                                                    {Kind::extension, 0.6},
                                                    {Kind::triaxial, 0.3},
                                                    {Kind::triaxial, 0.1},
                                                    {Kind::isotropic, 0.9},
                                                    {Kind::uniaxial, 0.6}};

std::string name(const std::pair<Kind, double> &branch)
{
  return words_of(branch.first) + " from " + std::to_string(branch.second);
}

/// A cap whose tables but that of p_b are constant.
DruckerPragerCap constant_cap()
{
  DruckerPragerCapParameters parameters;
  parameters.elasticity = {2e9, 0.2};
  parameters.cohesion = DensityTable(0.4e6);
  parameters.friction_angle = DensityTable(55 * std::numbers::pi / 180);
  parameters.eccentricity = DensityTable(0.6);
  parameters.transition = 0.02;
  return DruckerPragerCap(parameters);
}

ModifiedCamClay cam_clay()
{
  return ModifiedCamClay();
}
FkmGurson gurson()
{
  return FkmGurson();
}

/// The irreversible strain at yield is the offset, so that the hardening
/// variable is off by it at most: the point lies between the surfaces of
/// hardening that is less and more by it, up to the stress tolerance.
/// @param yield  F of p, q and of a plastic compaction since the state reached;
///               negative inside, of the order of a strain of stress
template <class Law, class Yield>
void expect_between(Powder<Law> &powder, const Yield &yield)
{
  for (const auto &branch : branches) {
    const auto found = powder.yield(branch.first, branch.second);
    ASSERT_TRUE(found.contains(YieldCriterion::strain)) << name(branch);
    const YieldPoint &point = found.at(YieldCriterion::strain);
    const double p = point.pressure, q = point.deviatoric_stress;
    const double slack = 3 * stress_tolerance;
    const double less = yield(p, q, -offset), more = yield(p, q, offset);
    EXPECT_LE(std::min(less, more), slack) << name(branch);
    EXPECT_GE(std::max(less, more), -slack) << name(branch);
  }
}
} // namespace

TEST(YieldBranch, PointsOfACapLieOnItsSurface)
{
  Powder powder(constant_cap(), 0.7);
  const double start = powder.reached().plastic_compaction;
  expect_between(powder, [&](double p, double q, double more) {
    const auto surface = powder.law.surface(start + more);
    return surface.yield(p, q) / (surface.radius() + surface.centre);
  });
}

TEST(YieldBranch, PointsOfCamClayLieOnItsSurface)
{
  Powder powder(cam_clay(), 0.7);
  const auto &law = powder.law.parameters();
  const double pressure = powder.reached().yield_pressure;
  expect_between(powder, [&](double p, double q, double more) {
    // v changes with elastic strain, too; by less than 10 %.
    const double growth =
        1.1 / powder.density / (law.compression_index - law.swelling_index);
    return CamClaySurface<double>{law.critical_state_slope,
                                  pressure * std::exp(growth * more)}
        .yield(p, q);
  });
}

TEST(YieldBranch, PointsOfGursonLieOnItsSurface)
{
  Powder powder(gurson(), 0.85);
  const double porosity = powder.reached().porosity;
  expect_between(powder, [&](double p, double q, double more) {
    return powder.law.surface(1 - (1 - porosity) * std::exp(more)).yield(p, q);
  });
}

TEST(YieldBranch, PeakOfACapIsOnItsShearLine)
{
  Powder powder(constant_cap(), 0.7);
  for (const double share : {0.1, 0.3}) {
    const auto found = powder.yield(Kind::compression, share);
    ASSERT_TRUE(found.contains(YieldCriterion::peak));
    const YieldPoint &point = found.at(YieldCriterion::peak);
    // q = d + p tan(beta), which does not harden.
    EXPECT_NEAR(point.deviatoric_stress,
                0.4e6 + point.pressure * std::tan(55 * std::numbers::pi / 180),
                1e-3 * point.deviatoric_stress);
  }
}

TEST(YieldBranch, FlowOfCamClayIsNormalToItsSurface)
{
  Powder powder(cam_clay(), 0.7);
  const CamClaySurface<double> surface{
      powder.law.parameters().critical_state_slope,
      powder.reached().yield_pressure};
  for (const auto &branch : branches) {
    const auto found = powder.yield(branch.first, branch.second);
    const YieldPoint &point = found.at(YieldCriterion::strain);
    const double p = point.pressure, q = point.deviatoric_stress;
    const double expected =
        std::atan2(surface.by_q_over_q(p, q) * q, surface.by_p(p, q));
    // Near the shear limit the normal turns by 2 q / p_c per strain of stress;
    // within the offset hardening moves stress by half a per cent.
    EXPECT_NEAR(
        std::atan2(point.plastic_shear_strain, point.plastic_volumetric_strain),
        expected,
        0.03)
        << name(branch);
  }
}

TEST(YieldBranch, LessOffsetIsNearerToTheFirstYield)
{
  Powder powder(cam_clay(), 0.7);
  double before = 1;
  for (const double share : {1e-3, 5e-4, 2.5e-4}) {
    powder.points.unpack(0, powder.state);
    ASSERT_EQ(unload_to(powder.points, 0.9 * powder.pressure, driving()),
              PathEnd::finished);
    const ModuliOverPressure moduli(
        {powder.moduli, measure_moduli(powder.points, small).value()});
    const BranchEnd end = drive_branch(
        powder.points, Kind::isotropic, {share, 0}, moduli, driving());
    const double more = end.points.at(0).pressure / powder.pressure - 1;
    EXPECT_GT(more, 0);
    EXPECT_LT(more, 0.6 * before); // hardening is linear in so small a strain
    before = more;
  }
}

TEST(SmallProbes, FindTheModuliOfTheLaw)
{
  const Powder cap(constant_cap(), 0.7);
  // Finite strains of 1e-4.
  EXPECT_NEAR(cap.moduli.youngs_modulus(), 2e9, 2e9 * 2 * small);
  EXPECT_NEAR(cap.moduli.poissons_ratio(), 0.2, 2 * small);
  const Powder clay(cam_clay(), 0.7);
  const auto &law = clay.law.parameters();
  const double bulk = clay.pressure / (clay.density * law.swelling_index);
  // The pressure changes by that much on the way.
  const double change = bulk * small / clay.pressure;
  EXPECT_NEAR(clay.moduli.bulk, bulk, bulk * change);
  EXPECT_NEAR(clay.moduli.poissons_ratio(), law.poissons_ratio, 2 * change);
}

TEST(SmallProbes, LeaveThePointAsItWas)
{
  Powder powder(constant_cap(), 0.7);
  std::vector<char> state;
  powder.points.pack(0, state);
  EXPECT_EQ(state, powder.state);
}

TEST(SmallProbes, ArePowersOfThePressureInBetween)
{
  const ModuliOverPressure moduli({{4e6, 200e6, 90e6}, {1e6, 100e6, 30e6}});
  EXPECT_DOUBLE_EQ(moduli.at(2e6).bulk, 100e6 * std::sqrt(2.));
  EXPECT_DOUBLE_EQ(moduli.at(2e6).shear, 30e6 * std::sqrt(3.));
  EXPECT_DOUBLE_EQ(moduli.at(0).bulk, 100e6);
  EXPECT_DOUBLE_EQ(moduli.at(1e9).shear, 90e6);
}
} // namespace tamp::fem
