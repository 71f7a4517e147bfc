// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/cap_surface.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/path_driver.h>
#include <tests/fem/laws/random_paths.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <set>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Surface = DruckerPragerCap::Surface;
using Points = ContinuumPoints<DruckerPragerCap>;

/// The return is polished to 1e-10 of the size of the surface.
constexpr double yield_tolerance = 1e-9;

Points one_point(const DruckerPragerCapParameters &parameters = {})
{
  return Points(DruckerPragerCap(parameters), 1);
}

PathStage strain_stage(const std::array<double, 3> &strain,
                       const double increment)
{
  PathStage stage;
  for (unsigned i = 0; i < 3; ++i) {
    stage.components[i].value = strain[i];
    stage.components[i].relative = true;
  }
  stage.maximum_increment = increment;
  return stage;
}

/// Drives a point and looks at each committed state.
template <class Look>
void drive(Points &points, const std::vector<PathStage> &stages, Look look)
{
  EXPECT_EQ(drive_path(points,
                       stages,
                       {},
                       [&](const PathRecord &record) {
                         look(points.state(0), record);
                       }),
            PathEnd::finished);
}

void nothing(const DruckerPragerCap::State &, const PathRecord &) {}

/// The constants of a published-form check; stresses in MPa.
CapConstants<double> check_constants()
{
  const double d = 2, beta = 55 * std::numbers::pi / 180, R = 0.6, p_a = 40;
  return {d, beta, R, p_a + R * (d + p_a * std::tan(beta)), 0.03};
}

TEST(CapSurface, PointOfDieCalibrationIsOnTheCap)
{
  // In a die without radial plastic strain: flow.shear / flow.compaction =
  // 2/3 at p = 64.0265, q = 42.5309 for these constants (rounded to 4 digits).
  const CapSurface<double> surface(check_constants());
  EXPECT_NEAR(surface.centre, 40, 1e-12);
  EXPECT_NEAR(surface.yield(64.0265, 42.5309), 0, 1e-4);
  const auto flow = surface.flow(64.0265, 42.5309);
  EXPECT_NEAR(flow.shear / flow.compaction, 2. / 3, 1e-5);
}

TEST(CapSurface, DieCalibrationFindsTheCentre)
{
  // R_c^2 = 2 c^2 (p - p_a) / (3 q) in the equation of the cap, solved for p_a.
  const CapSurface<double> s(check_constants());
  const double p = 64.0265, q = 42.5309, d = s.cohesion, t = s.tan_beta;
  const double c2 = s.factor * s.factor;
  const double root = std::sqrt(9 * q * q + 24 * c2 * d * q * t +
                                8 * c2 * t * t * (3 * p * q + 2 * q * q));
  const double p_a = (-(3 * q + 4 * c2 * d * t) + root) / (4 * c2 * t * t);
  EXPECT_NEAR(p_a, 40, 1e-4); // p and q have four digits after the point
  EXPECT_NEAR(std::sqrt(2 * c2 * (p - p_a) / (3 * q)), s.eccentricity, 1e-5);
}

TEST(CapSurface, BranchesJoin)
{
  const CapSurface<double> s(check_constants());
  EXPECT_NEAR(s.yield(s.apex(), 0), 0, 1e-12);
  EXPECT_NEAR(s.yield(s.centre, s.top()), 0, 1e-12);
  EXPECT_NEAR(s.yield(s.centre + 1e-9, s.top()), 0, 1e-8);
  EXPECT_NEAR(s.yield(s.centre + s.radius(), 0), 0, 1e-12);
  // The arc leaves the shear line as its tangent.
  const double p = s.transition_begin(), h = 1e-5;
  EXPECT_NEAR(s.shear_limit(p), s.cohesion + p * s.tan_beta, 1e-12);
  EXPECT_NEAR((s.shear_limit(p + h) - s.shear_limit(p)) / h, s.tan_beta, 1e-3);
  // The formula of the arc as it is printed.
  const double off = 0.3 * (s.centre - p), at = s.centre - off;
  const double height =
      s.shear_limit(at) - (1 - s.transition * s.inverse_cosine) * s.strength;
  EXPECT_NEAR(std::hypot(off, height), s.transition * s.strength, 1e-12);
}

TEST(CapSurface, FlowOnTheCapIsNormal)
{
  const CapSurface<double> s(check_constants());
  const double h = 1e-6;
  for (const double angle : {0.1, 0.8, 1.5}) {
    const double p = s.centre + s.radius() * std::cos(angle);
    const double q = s.top() * std::sin(angle);
    const auto flow = s.flow(p, q);
    const double by_p = s.yield(p + h, q) - s.yield(p - h, q);
    const double by_q = s.yield(p, q + h) - s.yield(p, q - h);
    EXPECT_NEAR(
        flow.shear * by_p, flow.compaction * by_q, 1e-8 * flow.compaction);
  }
}

TEST(DruckerPragerCap, IsotropicPathFollowsTheTable)
{
  auto points = one_point();
  const auto hardening = mcc_ph102::hardening();
  unsigned plastic = 0;
  drive(points,
        {strain_stage({-0.3, -0.3, -0.3}, 3e-3)},
        [&](const DruckerPragerCap::State &state, const PathRecord &) {
          if (state.surface == Surface::none)
            return;
          ++plastic;
          const double p_b = hardening.read(state.plastic_compaction).value;
          EXPECT_NEAR(pressure(state.stress), p_b, 1e-6 * p_b);
          EXPECT_LT(deviatoric_stress(state.stress), 1e-9 * p_b);
        });
  EXPECT_GT(plastic, 90u);
}

TEST(DruckerPragerCap, IsotropicPressingReturnsEveryRowOfTheTable)
{
  // As published: p_b [MPa] at densities, the last three at strains.
  std::vector<std::array<double, 2>> rows{{0.30, 0.609},
                                          {0.40, 4.03},
                                          {0.50, 10.7},
                                          {0.60, 20.5},
                                          {0.70, 35.78},
                                          {0.80, 64.7},
                                          {0.90, 127.9},
                                          {0.93, 170},
                                          {0.3 * std::exp(1.16), 257},
                                          {0.3 * std::exp(1.193922), 368},
                                          {0.3 * std::exp(1.202972), 823}};
  DruckerPragerCapParameters parameters;
  parameters.initial_relative_density = 0.3;
  const DruckerPragerCap law(parameters);
  const auto pressed = [&](const DruckerPragerCap::State &old, double strain) {
    auto now = old;
    Deformation increment;
    for (unsigned i = 0; i < 3; ++i)
      increment.relative_F[i][i] = std::exp(-strain);
    EXPECT_NE(law.respond(old, now, increment, Want::stress).status,
              Status::failed);
    return now;
  };
  const auto density = [](const DruckerPragerCap::State &state) {
    return 0.3 * std::exp(state.plastic_compaction); // what unloading leaves
  };
  auto state = law.initial_state();
  for (const auto &[wanted, p_b] : rows) {
    double least = 0, most = 2e-3;
    for (; density(pressed(state, most)) <= wanted;
         state = pressed(state, most))
      ;
    for (unsigned i = 0; i < 60; ++i) {
      const double middle = 0.5 * (least + most);
      (density(pressed(state, middle)) > wanted ? most : least) = middle;
    }
    EXPECT_NEAR(pressure(pressed(state, least).stress) / 1e6, p_b, 1e-6 * p_b)
        << wanted;
    EXPECT_LT(deviatoric_stress(state.stress), 1e-9 * p_b * 1e6);
  }
}

TEST(DruckerPragerCap, StartDensityAgreesWithTheTable)
{
  // From whatever density: the first yield is at the p_b of that density.
  const auto hardening = mcc_ph102::hardening();
  for (const double density : {0.3, 0.3411, 0.6, 0.85}) {
    DruckerPragerCapParameters parameters;
    parameters.initial_relative_density = density;
    auto points = one_point(parameters);
    const double p_b = hardening.read(std::log(density / 0.3)).value;
    double first = 0;
    drive(points,
          {strain_stage({-0.03, -0.03, -0.03}, 5e-5)},
          [&](const DruckerPragerCap::State &state, const PathRecord &) {
            if (first <= 0 && state.surface == Surface::cap)
              first = pressure(state.stress);
          });
    EXPECT_NEAR(first / p_b, 1, 0.01) << density;
  }
}

TEST(DruckerPragerCap, UniaxialPathStaysOnItsSurface)
{
  auto points = one_point();
  unsigned on_cap = 0;
  double before = 0, ratio = 0;
  drive(points,
        {strain_stage({0, 0, -0.8}, 2e-3)},
        [&](const DruckerPragerCap::State &state, const PathRecord &record) {
          EXPECT_LE(points.law().yield(state), yield_tolerance);
          if (state.surface == Surface::cap) {
            ++on_cap;
            EXPECT_GE(points.law().yield(state), -yield_tolerance);
          }
          EXPECT_NEAR(
              state.relative_density * determinant(record.F), 0.3411, 1e-10);
          EXPECT_LE(state.stress[2][2], before);
          before = state.stress[2][2];
          ratio = state.stress[0][0] / state.stress[2][2];
        });
  EXPECT_GT(on_cap, 350u);
  // Radial over axial stress of microcrystalline cellulose: 0.25 to 0.45.
  EXPECT_GT(ratio, 0.2);
  EXPECT_LT(ratio, 0.6);
}

TEST(DruckerPragerCap, StiffPowderMeetsTheDieCalibration)
{
  // Nearly rigid: no radial plastic strain on a uniaxial path, so R_c^2 = 2 c^2
  // (p - p_a) / (3 q) at every point of it.
  DruckerPragerCapParameters parameters;
  parameters.elasticity = {1e14, 0.2};
  parameters.cohesion = 2e6;
  parameters.friction_angle = 55 * std::numbers::pi / 180;
  parameters.eccentricity = 0.6;
  parameters.transition = 0.03;
  auto points = one_point(parameters);
  drive(points, {strain_stage({0, 0, -0.3}, 2e-3)}, nothing);
  const auto &state = points.state(0);
  const auto s = points.law().surface(state.plastic_compaction);
  const double p = pressure(state.stress), q = deviatoric_stress(state.stress);
  EXPECT_EQ(state.surface, Surface::cap);
  // Elastic strains are 1e-6 of the plastic ones.
  EXPECT_NEAR(
      std::sqrt(2 * s.factor * s.factor * (p - s.centre) / (3 * q)), 0.6, 1e-4);
}

TEST(DruckerPragerCap, EverySurfaceIsReached)
{
  DruckerPragerCapParameters parameters;
  parameters.transition = 0.03;
  std::set<Surface> reached;
  const auto note = [&](const Points &points) {
    return [&](const DruckerPragerCap::State &state, const PathRecord &) {
      reached.insert(state.surface);
      EXPECT_LE(points.law().yield(state), yield_tolerance);
    };
  };
  const PathStage load = strain_stage({0, 0, -0.3}, 2e-3);
  { // pulling in all directions ends at the apex
    auto points = one_point(parameters);
    drive(points, {strain_stage({0.03, 0.03, 0.03}, 1e-3)}, note(points));
    const auto &state = points.state(0);
    EXPECT_EQ(state.surface, Surface::apex);
    const double apex = points.law().surface(state.plastic_compaction).apex();
    EXPECT_NEAR(pressure(state.stress), apex, 1e-6 * std::abs(apex));
  }
  { // unloading in the die fails in shear
    auto points = one_point(parameters);
    drive(points, {load, strain_stage({0, 0, 0.06}, 5e-4)}, note(points));
    EXPECT_EQ(points.state(0).surface, Surface::shear);
  }
  { // shearing at constant volume ends at the critical state, p = p_a
    auto points = one_point(parameters);
    drive(points, {load, strain_stage({0.2, -0.1, -0.1}, 1e-3)}, note(points));
    const auto &state = points.state(0);
    const auto s = points.law().surface(state.plastic_compaction);
    EXPECT_NEAR(pressure(state.stress), s.centre, 1e-2 * s.centre);
  }
  EXPECT_EQ(reached,
            (std::set<Surface>{Surface::none,
                               Surface::shear,
                               Surface::transition,
                               Surface::cap,
                               Surface::apex}));
}

TEST(DruckerPragerCap, UnloadingIsElasticAndReversible)
{
  auto points = one_point();
  drive(points, {strain_stage({0, 0, -0.6}, 2e-3)}, nothing);
  const auto loaded = points.state(0);
  drive(points, {strain_stage({0, 0, 2e-3}, 1e-3)}, nothing);
  EXPECT_EQ(points.state(0).surface, Surface::none);
  EXPECT_EQ(points.state(0).plastic_compaction, loaded.plastic_compaction);
  drive(points, {strain_stage({0, 0, -2e-3}, 1e-3)}, nothing);
  EXPECT_LT((points.state(0).stress - loaded.stress).norm(),
            1e-9 * loaded.stress.norm());
}

TEST(DruckerPragerCap, RandomPathsStayFiniteAndInside)
{
  for (const double transition : {0., 0.03}) {
    DruckerPragerCapParameters parameters;
    parameters.transition = transition;
    auto points = one_point(parameters);
    const auto start = points.state(0);
    // Densities from 0.34 to 1.
    test::follow_random_paths(points, {.paths = 200}, [&] {
      EXPECT_LE(points.law().yield(points.state(0)), yield_tolerance);
    });
    EXPECT_NE(points.state(0).stress, start.stress);
  }
}

TEST(DruckerPragerCap, OutsideItsTablesItIsDoubtful)
{
  auto points = one_point();
  Status first = Status::failed, last = Status::failed;
  drive(points,
        {strain_stage({-0.5, -0.5, -0.5}, 5e-3)},
        [&](const DruckerPragerCap::State &, const PathRecord &record) {
          if (record.step == 1)
            first = record.response.status;
          last = record.response.status;
        });
  EXPECT_EQ(first, Status::converged);
  EXPECT_EQ(last, Status::doubtful);
  // The last line of the hardening table keeps the density near 1.
  EXPECT_LT(points.state(0).plastic_compaction, std::log(1.02 / 0.3));
}

TEST(DruckerPragerCap, RefusesImpossibleConstants)
{
  const auto refused = [](const auto &change) {
    DruckerPragerCapParameters parameters;
    change(parameters);
    EXPECT_THROW(DruckerPragerCap{parameters}, std::invalid_argument);
  };
  refused([](auto &p) { p.cohesion = -1.; });
  refused([](auto &p) { p.friction_angle = 55.; }); // degrees
  refused([](auto &p) { p.eccentricity = 0.; });
  refused([](auto &p) { p.transition = 0.5; });
  refused([](auto &p) {
    p.hardening = DensityTable({{0, 1}, {2e6, 1e6}}, "p_b");
  });
  refused([](auto &p) { p.initial_relative_density = 1.5; });
  refused([](auto &p) { p.maximum_strain_increment = 0; });
}
} // namespace
} // namespace tamp::fem
