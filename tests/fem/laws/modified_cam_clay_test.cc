// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/density_table.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/mcc_ph102.h>
#include <fem/laws/modified_cam_clay.h>
#include <tests/fem/laws/random_paths.h>
#include <tests/fem/laws/rate_reference.h>

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Points = ContinuumPoints<ModifiedCamClay>;

Points one_point(const ModifiedCamClayParameters &parameters = {})
{
  return Points(ModifiedCamClay(parameters), 1);
}

/// The law's rate equations, written anew.
struct CamClayRates {
  ModifiedCamClayParameters c;
  RateCoefficients operator()(const double p,
                              const double q,
                              const double density,
                              const double p_c) const
  {
    const double M2 = c.critical_state_slope * c.critical_state_slope;
    const double K =
        std::max(p, c.floor_pressure) / (density * c.swelling_index);
    const double G =
        1.5 * K * (1 - 2 * c.poissons_ratio) / (1 + c.poissons_ratio);
    return {K,
            G,
            q * q / M2 + p * (p - p_c),
            2 * p - p_c,
            2 * q / M2,
            -p,
            p_c / (density * (c.compression_index - c.swelling_index))};
  }
};

double difference(const std::vector<Leg> &legs,
                  const ModifiedCamClayParameters &parameters = {})
{
  auto points = one_point(parameters);
  const auto &start = points.state(0);
  return worst_difference(
      points,
      RateReference(CamClayRates{parameters}),
      {start.stress, start.relative_density, start.yield_pressure},
      legs);
}

/// A strain along the axis with equal lateral strains.
Leg triaxial(const double axial, const double lateral, const unsigned steps)
{
  return leg({lateral, lateral, axial, 0, 0, 0}, steps);
}

double volume(const ModifiedCamClay::State &state)
{
  return 1 / state.relative_density;
}

/// p and q, far from rounding.
double p_of(const Points &points)
{
  return pressure(points.state(0).stress);
}
double q_of(const Points &points)
{
  return deviatoric_stress(points.state(0).stress);
}

TEST(ModifiedCamClay, IsotropicPathFollowsItsLines)
{
  // Exact whatever the increment: rounding, and 1e-11 of the return.
  const double tolerance = 1e-9;
  for (const unsigned increments : {1u, 7u, 100u}) {
    auto points = one_point();
    const ModifiedCamClayParameters c;
    ASSERT_TRUE(follow(points, triaxial(-0.1, -0.1, increments)));
    const auto a = points.state(0);
    ASSERT_TRUE(a.yielding);
    EXPECT_NEAR(pressure(a.stress) / a.yield_pressure, 1, tolerance);
    ASSERT_TRUE(follow(points, triaxial(-0.1, -0.1, increments)));
    const auto b = points.state(0);
    EXPECT_NEAR(volume(b),
                volume(a) - c.compression_index * std::log(pressure(b.stress) /
                                                           pressure(a.stress)),
                tolerance);
    ASSERT_TRUE(follow(points, triaxial(0.02, 0.02, increments)));
    const auto unloaded = points.state(0);
    EXPECT_FALSE(unloaded.yielding);
    EXPECT_GT(pressure(unloaded.stress), c.floor_pressure);
    EXPECT_NEAR(volume(unloaded),
                volume(b) -
                    c.swelling_index * std::log(pressure(unloaded.stress) /
                                                pressure(b.stress)),
                tolerance);
    // Below the floor pressure the line is straight and goes to zero.
    const double at_floor =
        volume(b) +
        c.swelling_index * std::log(pressure(b.stress) / c.floor_pressure);
    const double strain =
        std::log((at_floor + 0.5 * c.swelling_index) / volume(unloaded)) / 3;
    ASSERT_TRUE(follow(points, triaxial(strain, strain, increments)));
    EXPECT_NEAR(p_of(points) / c.floor_pressure, 0.5, 1e-6);
  }
}

TEST(ModifiedCamClay, UndrainedPathFollowsTheClosedForm)
{
  // lambda d ln p = -(lambda - kappa) d ln(M^2 + eta^2) at constant volume on
  // the surface; both are exact in the algorithm.
  const ModifiedCamClayParameters c;
  auto points = one_point();
  ASSERT_TRUE(follow(points, triaxial(-0.12, -0.08, 20)));
  const double M2 = std::pow(c.critical_state_slope, 2), p_0 = p_of(points),
               eta_0 = q_of(points) / p_0;
  ASSERT_TRUE(points.state(0).yielding);
  const double exponent =
      (c.compression_index - c.swelling_index) / c.compression_index;
  for (unsigned i = 0; i < 60; ++i) {
    ASSERT_TRUE(follow(points, triaxial(-0.004, 0.002, 1)));
    const double eta = q_of(points) / p_of(points);
    EXPECT_NEAR(p_of(points) / p_0,
                std::pow((M2 + eta_0 * eta_0) / (M2 + eta * eta), exponent),
                1e-8);
  }
  ASSERT_TRUE(follow(points, triaxial(-0.4, 0.2, 20)));
  EXPECT_NEAR(q_of(points) / (c.critical_state_slope * p_of(points)), 1, 1e-6);
  EXPECT_NEAR(p_of(points) / p_0,
              std::pow((M2 + eta_0 * eta_0) / (2 * M2), exponent),
              1e-6);
}

TEST(ModifiedCamClay, OverconsolidatedPowderSoftensToTheCriticalState)
{
  auto points = one_point();
  ASSERT_TRUE(follow(points, triaxial(-0.2, -0.2, 40)));
  ASSERT_TRUE(follow(points, triaxial(0.035, 0.035, 10)));
  ASSERT_LT(p_of(points), 0.4 * points.state(0).yield_pressure);
  const double hard = points.state(0).yield_pressure;
  ASSERT_TRUE(follow(points, triaxial(-0.6, 0.3, 100)));
  EXPECT_LT(points.state(0).yield_pressure, 0.9 * hard);
  // What is left decays with the strain: 1e-4 after 0.6.
  EXPECT_NEAR(q_of(points) / (1.8 * p_of(points)), 1, 1e-4);
}

TEST(ModifiedCamClay, StiffPowderMeetsTheDieRatio)
{
  // Nearly rigid: no lateral plastic strain in a die, so eps_q / eps_v = 2/3
  // and with normality 3 eta = M^2 - eta^2.
  ModifiedCamClayParameters c;
  c.swelling_index = 1e-4;
  auto points = one_point(c);
  ASSERT_TRUE(follow(points, triaxial(-0.2, 0, 40)));
  const auto before = points.state(0);
  ASSERT_TRUE(follow(points, triaxial(-0.01, 0, 2)));
  const auto &after = points.state(0);
  // Elastic strains are of the order kappa / lambda = 2e-4 of the plastic ones.
  EXPECT_NEAR((after.plastic_shear - before.plastic_shear) /
                  (after.plastic_compaction - before.plastic_compaction),
              2. / 3,
              1e-3);
  const double M2 = std::pow(c.critical_state_slope, 2);
  EXPECT_NEAR(
      q_of(points) / p_of(points), (std::sqrt(9 + 4 * M2) - 3) / 2, 1e-3);
}

/// Stress against the fine integration, relative.
constexpr double reference_tolerance = 1e-4;

TEST(ModifiedCamClay, ProportionalPathMeetsFineIntegration)
{
  EXPECT_LT(difference({leg({-0.2, -0.1, -0.3, 0, 0, 0}, 30)}),
            reference_tolerance);
}

TEST(ModifiedCamClay, UniaxialPathMeetsFineIntegration)
{
  EXPECT_LT(difference({triaxial(-0.7, 0, 70),
                        triaxial(0.05, 0, 10),
                        triaxial(-0.1, 0, 10)}),
            reference_tolerance);
}

TEST(ModifiedCamClay, TurningShearMeetsFineIntegration)
{
  EXPECT_LT(difference({leg({-0.1, -0.1, -0.1, 0, 0, 0}, 20),
                        leg({0, 0, 0, 0.2, 0, 0}, 20),
                        leg({-0.02, 0.02, 0, 0, 0.2, 0}, 20),
                        leg({0, 0, 0, -0.2, 0, 0.1}, 20)}),
            reference_tolerance);
}

TEST(ModifiedCamClay, NewtonConvergesQuadratically)
{
  auto points = one_point();
  ASSERT_TRUE(follow(points, triaxial(-0.2, -0.2, 40)));
  const double stress = points.state(0).stress[0][0];
  const auto residuals = newton_residuals(points, -0.02, stress);
  const double order = newton_order(residuals, 1e-9 * std::abs(stress));
  std::cout << "order of Newton's method " << order << '\n';
  // Of three residuals: what is left of the higher terms is below 0.2.
  EXPECT_NEAR(order, 2, 0.2);
  EXPECT_LT(residuals.back(), 1e-9 * std::abs(stress));
}

TEST(ModifiedCamClay, RandomPathsStayFiniteAndInside)
{
  auto points = one_point();
  test::follow_random_paths(points, {}, [&] {
    // The return is polished to 1e-11, rotation adds rounding.
    const auto surface = points.law().surface(points.state(0));
    EXPECT_LE(surface.yield(p_of(points), q_of(points)), 1e-9);
  });
}

TEST(ModifiedCamClay, DefaultsAreThoseOfCellulose)
{
  const ModifiedCamClayParameters c;
  const double start = 1 / c.initial_relative_density;
  for (const double density : {0.4, 0.5, 0.6, 0.7, 0.8}) {
    const double p_b =
        mcc_ph102::hardening()
            .read(std::log(density / mcc_ph102::reference_density))
            .value;
    const double on_line =
        c.initial_yield_pressure *
        std::exp((start - 1 / density) / c.compression_index);
    // As documented; the tables are those of one cellulose.
    EXPECT_NEAR(on_line / p_b, 1, 0.15) << density;
  }
}

TEST(ModifiedCamClay, AboveFullDensityItIsDoubtful)
{
  ModifiedCamClayParameters c;
  c.initial_relative_density = 0.99;
  auto points = one_point(c);
  std::vector<Response> answer(1);
  for (const double strain : {0.001, 0.02}) {
    points.evaluate(std::vector<Deformation>(
                        1, {exponential(triaxial(-strain, 0, 1).strain)}),
                    Want::stress,
                    answer);
    EXPECT_EQ(answer[0].status,
              strain < 0.01 ? Status::converged : Status::doubtful);
  }
}

TEST(ModifiedCamClay, RefusesImpossibleConstants)
{
  const auto refused = [](const auto &change) {
    ModifiedCamClayParameters parameters;
    change(parameters);
    EXPECT_THROW(ModifiedCamClay{parameters}, std::invalid_argument);
  };
  refused([](auto &p) { p.critical_state_slope = 0; });
  refused([](auto &p) { p.compression_index = p.swelling_index; });
  refused([](auto &p) { p.swelling_index = -0.01; });
  refused([](auto &p) { p.poissons_ratio = 0.5; });
  refused([](auto &p) { p.initial_relative_density = 1.2; });
  refused([](auto &p) { p.initial_yield_pressure = 0; });
  refused([](auto &p) { p.floor_pressure = 0; });
  refused([](auto &p) { p.integration_tolerance = 1; });
}
} // namespace
} // namespace tamp::fem
