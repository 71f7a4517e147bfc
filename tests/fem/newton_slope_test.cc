// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/fkm_gurson.h>
#include <fem/laws/modified_cam_clay.h>
#include <tests/fem/die_bench.h>
#include <tests/fem/die_run.h>

#include <cmath>
#include <iostream>

namespace tamp::fem
{
namespace
{
using namespace test;

/// Under a dome the powder flows: nothing is uniform.
DieSettings domed_die()
{
  DieSettings settings = frictionless_die(3, 4);
  settings.geometry.upper_face.kind = PunchFace::Kind::convex;
  settings.geometry.upper_face.radius = 12e-3;
  return settings;
}

/// Flat punches, friction on the wall.
DieSettings rough_die()
{
  DieSettings settings = frictionless_die(3, 4);
  settings.friction[die_wall] = FrictionCoefficient(0.2);
  return settings;
}

/// A way that the upper punch goes at once, after others [m].
struct Way {
  double first, last;
  unsigned steps; ///< to the first
};

/// Force residual after each iteration of the last way, found by asking for
/// more and more iterations.
template <class Law>
std::vector<double>
residuals_of(const Law &law, const DieSettings &settings, const Way &way)
{
  std::vector<double> residuals;
  for (unsigned iterations = 2; iterations <= 6; ++iterations) {
    DieBench bench(settings, law);
    for (unsigned step = 0; step < way.steps; ++step)
      bench.move(-way.first / way.steps, 0);
    SolverSettings solver = settings.solver;
    solver.force_tolerance = 1e-300;
    solver.maximum_iterations = iterations;
    Equilibrium last(bench.press, solver, 0.5);
    Motion motion;
    motion[upper_punch].displacement = -way.last;
    residuals.push_back(
        last.attempt(motion, Increment(number_of_unknowns(bench.mesh), 0.))
            .force_residual);
  }
  return residuals;
}

template <class Law>
void expect_quadratic(const Law &law,
                      const DieSettings &settings,
                      const Way &way)
{
  const auto residuals = residuals_of(law, settings, way);
  std::cout << Law::name << ":";
  for (const double residual : residuals)
    std::cout << " " << residual;
  // The first three below 1e-2; rounding takes over soon.
  std::size_t i = 0;
  while (i + 3 < residuals.size() && residuals[i] > 1e-2)
    ++i;
  const double slope = std::log(residuals[i + 2] / residuals[i + 1]) /
                       std::log(residuals[i + 1] / residuals[i]);
  std::cout << ", slope " << slope << "\n";
  EXPECT_NEAR(slope, 2, 0.2) << Law::name;
  EXPECT_LT(residuals.back(), 1e-12) << Law::name;
}

/// Elastic, ten times as stiff at a relative density of 0.7.
Elastic stiffening_law()
{
  ElasticParameters parameters;
  parameters.elasticity.youngs_modulus =
      DensityTable({{0.5, 0.7}, {1e9, 1e10}}, "stiffness");
  parameters.initial_relative_density = 0.5;
  return Elastic(parameters);
}
} // namespace

TEST(NewtonUnderADome, IsQuadraticForStiffeningElasticity)
{
  expect_quadratic(stiffening_law(), domed_die(), {2e-4, 2e-3, 2});
}

TEST(NewtonUnderADome, IsQuadraticForTheCap)
{
  expect_quadratic(DruckerPragerCap(), domed_die(), {2e-4, 4e-4, 2});
}

TEST(NewtonUnderADome, IsQuadraticForCamClay)
{
  expect_quadratic(ModifiedCamClay(), domed_die(), {0, 1.2e-3, 0});
}

TEST(NewtonUnderADome, IsQuadraticForFkmGurson)
{
  expect_quadratic(FkmGurson(), domed_die(), {2e-4, 1e-4, 2});
}

// Once all nodes of the wall slip, as in steady pressing; where stick and slip
// change in an iteration the equations have a kink.
TEST(NewtonWithFriction, IsQuadraticForStiffeningElasticity)
{
  DieSettings settings = domed_die();
  settings.friction[die_wall] = FrictionCoefficient(0.2);
  expect_quadratic(stiffening_law(), settings, {2e-4, 1.8e-3, 2});
}

TEST(NewtonWithFriction, IsQuadraticForTheCap)
{
  expect_quadratic(DruckerPragerCap(), rough_die(), {2e-4, 3e-4, 4});
}

TEST(NewtonWithFriction, IsQuadraticForCamClay)
{
  expect_quadratic(ModifiedCamClay(), rough_die(), {2e-4, 6e-4, 2});
}

TEST(NewtonWithFriction, IsQuadraticForFkmGurson)
{
  expect_quadratic(FkmGurson(), rough_die(), {1e-4, 1e-4, 8});
}
} // namespace tamp::fem
