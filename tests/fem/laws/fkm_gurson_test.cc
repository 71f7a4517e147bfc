// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/fkm_gurson.h>
#include <tests/fem/laws/random_paths.h>
#include <tests/fem/laws/rate_reference.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <numbers>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Points = ContinuumPoints<FkmGurson>;

Points one_point(const FkmGursonParameters &parameters = {})
{
  return Points(FkmGurson(parameters), 1);
}

/// F at p, q and density, written anew from the published forms.
double published(const FkmGursonParameters &c,
                 const double p,
                 const double q,
                 const double D)
{
  const double s = c.solid_yield_stress, f = 1 - D;
  const double p_y = 2.97 * D * D * s * (D - 0.64) / 0.36;
  const double a = c.vertex_rounding * p_y, top = 1.2 * p_y;
  const double r = (std::hypot(q, a) - a) * top / (std::hypot(top, a) - a);
  const double fkm = std::pow(std::sqrt(5) * p / (3 * p_y), 2) +
                     std::pow(5 * r / (18 * p_y) + 2. / 3, 2) - 1;
  const double gurson =
      q * q / (s * s) + 2 * f * std::cosh(1.5 * p / s) - 1 - f * f;
  const double x = std::clamp((D - 0.77) / 0.13, 0., 1.);
  const double w = x * x * (3 - 2 * x);
  return w <= 0 ? fkm : w >= 1 ? gurson : (1 - w) * fkm + w * gurson;
}

/// The law's rate equations; the gradient by differences.
struct FkmGursonRates {
  FkmGursonParameters c;
  RateCoefficients
  operator()(const double p, const double q, double, const double D) const
  {
    const double E =
        c.solid_youngs_modulus * std::exp(-c.elastic_exponent * (1 - D));
    const double nu = c.solid_poissons_ratio;
    const double h = 1e-5 * c.solid_yield_stress, d = 1e-6;
    return {E / (3 * (1 - 2 * nu)),
            E / (2 * (1 + nu)),
            published(c, p, q, D),
            (published(c, p + h, q, D) - published(c, p - h, q, D)) / (2 * h),
            (published(c, p, q + h, D) - published(c, p, q - h, D)) / (2 * h),
            (published(c, p, q, D + d) - published(c, p, q, D - d)) / (2 * d),
            D};
  }
};

double difference(const std::vector<Leg> &legs,
                  const FkmGursonParameters &parameters = {})
{
  auto points = one_point(parameters);
  const auto &start = points.state(0);
  return worst_difference(
      points,
      RateReference(FkmGursonRates{parameters}),
      {start.stress, start.relative_density, 1 - start.porosity},
      legs);
}

Leg triaxial(const double axial, const double lateral, const unsigned steps)
{
  return leg({lateral, lateral, axial, 0, 0, 0}, steps);
}

double p_of(const FkmGurson::State &state)
{
  return -trace(state.stress) / 3;
}
double q_of(const FkmGurson::State &state)
{
  return std::sqrt(1.5) * deviator(state.stress).norm();
}

/// Closed forms hold to rounding.
constexpr double rounding = 1e-12;

TEST(FkmGurson, LooseSurfaceMeetsFkmOnItsAxes)
{
  const FkmGurson law;
  const auto &c = law.parameters();
  for (const double D : {0.66, 0.70, 0.77}) {
    const double p_y = 2.97 * D * D * c.solid_yield_stress * (D - 0.64) / 0.36;
    const auto surface = law.surface(1 - D);
    EXPECT_NEAR(surface.largest_pressure() / p_y, 1, rounding) << D;
    EXPECT_NEAR(surface.smallest_pressure() / p_y, -1, rounding) << D;
    EXPECT_NEAR(surface.shear_limit(0) / p_y, 1.2, rounding) << D;
  }
}

TEST(FkmGurson, DenseSurfaceMeetsGursonOnItsAxes)
{
  const FkmGurson law;
  const double s = law.parameters().solid_yield_stress;
  for (const double D : {0.90, 0.95, 0.999}) {
    const double f = 1 - D;
    const auto surface = law.surface(f);
    EXPECT_NEAR(surface.largest_pressure() / s, -2. / 3 * std::log(f), 1e-10);
    EXPECT_NEAR(surface.shear_limit(0) / s, 1 - f, 1e-10);
  }
}

TEST(FkmGurson, RoundingStaysAsSmallAsItSays)
{
  FkmGursonParameters c;
  for (const double size : {0.01, 0.001}) {
    c.vertex_rounding = size;
    const double D = 0.7;
    const auto surface = FkmGurson(c).surface(1 - D);
    const double p_y = surface.largest_pressure();
    for (const double share : {0.2, 0.5, 0.9, 0.99}) {
      const double sharp =
          3.6 * p_y * (std::sqrt(1 - 5. / 9 * share * share) - 2. / 3);
      EXPECT_NEAR(
          surface.shear_limit(share * p_y) / p_y, sharp / p_y, 1.01 * size)
          << share;
    }
  }
}

TEST(FkmGurson, BlendIsContinuousInItselfAndInItsGrowth)
{
  const FkmGurson law;
  for (const double D : {FkmGurson::blend_begin, FkmGurson::blend_end}) {
    const double h = 1e-5;
    const auto at = [&law](const double density) {
      const auto surface = law.surface(1 - density);
      return std::array{surface.largest_pressure(),
                        surface.shear_limit(0),
                        surface.shear_limit(0.5 * surface.largest_pressure())};
    };
    const auto below = at(D - h), here = at(D), above = at(D + h);
    for (unsigned i = 0; i < 3; ++i) {
      EXPECT_NEAR(below[i] / here[i], 1, 20 * h) << D; // 1 / D_y dD_y/dD < 20
      EXPECT_NEAR(above[i] / here[i], 1, 20 * h) << D;
      // One slope to both sides, up to h times the curvature.
      EXPECT_NEAR((above[i] - here[i]) / (here[i] - below[i]), 1, 0.05) << D;
    }
  }
  // Isotropic compaction hardens all the way.
  for (double D = 0.65; D < 0.99; D += 0.001)
    EXPECT_GT(law.surface(1 - D - 0.001).largest_pressure(),
              law.surface(1 - D).largest_pressure())
        << D;
}

TEST(FkmGurson, SurfaceIsConvex)
{
  const FkmGurson law;
  for (const double D :
       {0.66, 0.77, 0.79, 0.81, 0.83, 0.85, 0.87, 0.89, 0.95}) {
    const auto surface = law.surface(1 - D);
    std::vector<std::array<double, 2>> points;
    const double end = surface.largest_pressure();
    for (int i = -40; i <= 40; ++i) {
      const double p = end * std::sin(i * std::numbers::pi / 80);
      points.push_back({p, surface.shear_limit(p)});
      points.push_back({p, -surface.shear_limit(p)});
    }
    for (const auto &a : points)
      for (const auto &b : points)
        ASSERT_LE(surface.yield((a[0] + b[0]) / 2, std::abs(a[1] + b[1]) / 2),
                  1e-9)
            << D;
  }
}

TEST(FkmGurson, SurfaceIsThePublishedOne)
{
  const FkmGurson law;
  const auto &c = law.parameters();
  for (const double D : {0.66, 0.76, 0.80, 0.85, 0.95})
    for (const double p : {-0.2, 0.1, 0.5})
      for (const double q : {0.01, 0.2, 0.8}) {
        const double s = c.solid_yield_stress;
        const double expected = published(c, p * s, q * s, D);
        EXPECT_NEAR(law.surface(1 - D).yield(p * s, q * s),
                    expected,
                    rounding * (1 + std::abs(expected)));
      }
}

TEST(FkmGurson, FlowIsNormal)
{
  // Of small increments, which the gradient at their end describes to 1e-3.
  const FkmGurson law;
  const auto &c = law.parameters();
  for (const double strain : {0.05, 0.22, 0.35}) { // FKM, blend, Gurson
    auto points = one_point();
    ASSERT_TRUE(follow(points, triaxial(-strain, 0, 50)));
    const auto a = points.state(0);
    ASSERT_TRUE(follow(points, triaxial(-1e-6, 0, 1)));
    const auto b = points.state(0);
    const double compaction = std::log((1 - b.porosity) / (1 - a.porosity));
    const double shear = b.plastic_shear - a.plastic_shear;
    const auto at = FkmGursonRates{c}(p_of(b), q_of(b), 0, 1 - b.porosity);
    EXPECT_NEAR(shear / compaction / (at.by_q / at.by_p), 1, 1e-3) << strain;
  }
}

TEST(FkmGurson, IsotropicPathFollowsTheHydrostaticYield)
{
  auto points = one_point();
  bool gurson = false;
  for (unsigned i = 0; i < 160; ++i) {
    ASSERT_TRUE(follow(points, triaxial(-0.001, -0.001, 1)));
    const auto &state = points.state(0);
    if (!state.yielding)
      continue;
    const double limit =
        points.law().surface(state.porosity).largest_pressure();
    EXPECT_NEAR(p_of(state) / limit, 1, 1e-9); // as polished
    if (state.porosity < 0.1) {
      gurson = true;
      EXPECT_NEAR(p_of(state) / 1e8, -2. / 3 * std::log(state.porosity), 1e-8);
    }
  }
  EXPECT_TRUE(gurson);
  // On to ten times the yield stress: pores of 3e-7 are still followed.
  EXPECT_TRUE(follow(points, triaxial(-0.003, -0.003, 20)));
  const auto &state = points.state(0);
  EXPECT_GT(p_of(state), 10e8);
  EXPECT_NEAR(
      p_of(state) / (-2. / 3 * 1e8 * std::log(state.porosity)), 1, 1e-8);
}

/// Stress against the fine integration, relative.
constexpr double reference_tolerance = 1e-4;

TEST(FkmGurson, ProportionalPathMeetsFineIntegration)
{
  EXPECT_LT(difference({leg({-0.1, -0.05, -0.15, 0, 0, 0}, 30)}),
            reference_tolerance);
}

TEST(FkmGurson, UniaxialPathMeetsFineIntegration)
{
  EXPECT_LT(difference({triaxial(-0.35, 0, 70),
                        triaxial(0.01, 0, 10),
                        triaxial(-0.05, 0, 10)}),
            reference_tolerance);
}

TEST(FkmGurson, TurningShearMeetsFineIntegration)
{
  EXPECT_LT(difference({leg({-0.05, -0.05, -0.05, 0, 0, 0}, 20),
                        leg({0, 0, 0, 0.05, 0, 0}, 20),
                        leg({-0.02, 0.02, 0, 0, 0.05, 0}, 20),
                        leg({0, 0, 0, -0.05, 0, 0.03}, 20)}),
            reference_tolerance);
}

TEST(FkmGurson, NewtonConvergesQuadratically)
{
  auto points = one_point();
  ASSERT_TRUE(follow(points, triaxial(-0.06, -0.03, 20)));
  const double stress = points.state(0).stress[0][0];
  const auto residuals = newton_residuals(points, -0.01, stress);
  const double order = newton_order(residuals, 1e-9 * std::abs(stress));
  std::cout << "order of Newton's method " << order << '\n';
  // Of three residuals: what is left of the higher terms is below 0.2.
  EXPECT_NEAR(order, 2, 0.2);
  EXPECT_LT(residuals.back(), 1e-9 * std::abs(stress));
}

TEST(FkmGurson, LoosePowderCompactsUntilItCarries)
{
  FkmGursonParameters c;
  c.initial_relative_density = 0.55;
  auto points = one_point(c);
  std::vector<Response> answer(1);
  for (unsigned i = 0; i < 22; ++i) {
    points.evaluate(std::vector<Deformation>(
                        1, {exponential(triaxial(-0.01, 0, 1).strain)}),
                    Want::stress,
                    answer);
    points.commit();
    const auto &state = points.state(0);
    EXPECT_EQ(answer[0].status,
              1 - state.porosity < 0.64 ? Status::doubtful : Status::converged);
    if (1 - state.porosity < 0.64) { // a few times the floor, 1e5 Pa
      EXPECT_LT(-state.stress[2][2], 2.5e5);
    }
  }
  EXPECT_EQ(answer[0].status, Status::converged);
  EXPECT_GT(-points.state(0).stress[2][2], 5e6);
}

TEST(FkmGurson, RandomPathsStayFiniteAndInside)
{
  for (const double density : {0.60, 0.66, 0.80, 0.93}) {
    FkmGursonParameters c;
    c.initial_relative_density = density;
    auto points = one_point(c);
    const test::RandomPaths paths{20, 10, -3, 0.3};
    test::follow_random_paths(points, paths, [&] {
      // The return is polished to 1e-11, rotation adds rounding.
      const auto &state = points.state(0);
      EXPECT_LE(
          points.law().surface(state.porosity).yield(p_of(state), q_of(state)),
          1e-9)
          << density;
    });
  }
}

TEST(FkmGurson, RefusesImpossibleConstants)
{
  const auto refused = [](const auto &change) {
    FkmGursonParameters parameters;
    change(parameters);
    EXPECT_THROW(FkmGurson{parameters}, std::invalid_argument);
  };
  refused([](auto &p) { p.solid_yield_stress = 0; });
  refused([](auto &p) { p.solid_youngs_modulus = -1; });
  refused([](auto &p) { p.solid_poissons_ratio = 0.5; });
  refused([](auto &p) { p.elastic_exponent = -1; });
  refused([](auto &p) { p.random_packing_density = 0.8; });
  refused([](auto &p) { p.initial_relative_density = 1; });
  refused([](auto &p) { p.yield_floor = 0; });
  refused([](auto &p) { p.vertex_rounding = 0; });
  refused([](auto &p) { p.integration_tolerance = 0; });
}
} // namespace
} // namespace tamp::fem
