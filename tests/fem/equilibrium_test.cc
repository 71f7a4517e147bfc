// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/equilibrium.h>
#include <tests/fem/test_points.h>

#include <cmath>
#include <gtest/gtest.h>

namespace tamp::fem
{
namespace
{
using test::HenckyLaw;
using test::HenckyPoints;

HenckyLaw stiffening_law()
{
  HenckyLaw law;
  law.stiffening = 8;
  return law;
}

Mesh small_mesh()
{
  DieGeometry geometry;
  geometry.radial_elements = 3;
  geometry.axial_elements = 4;
  return build_mesh(geometry);
}

SolverSettings solver(NonlinearMethod method, double tolerance = 1e-10)
{
  SolverSettings settings;
  settings.method = method;
  settings.force_tolerance = tolerance;
  settings.displacement_tolerance = 1e-8;
  settings.maximum_iterations = 40;
  return settings;
}

Motion down(double distance)
{
  Motion motion;
  motion[upper_punch].displacement = -distance;
  return motion;
}

Tools tools_of(const Mesh &mesh, double friction)
{
  Tools tools;
  tools.surfaces = make_tools({}, mesh);
  tools.friction[die_wall] = FrictionCoefficient(friction);
  return tools;
}

/// Mesh, points and solver.
struct Bench {
  Mesh mesh = small_mesh();
  HenckyPoints points;
  Press press;
  Equilibrium equilibrium;

  explicit Bench(const SolverSettings &settings, double friction = 0.3)
      : points(mesh.number_of_points(), stiffening_law()),
        press(mesh, tools_of(mesh, friction), points, settings, Ranks()),
        equilibrium(press, settings, 0.2)
  {
  }

  Attempt attempt(const Motion &motion)
  {
    const Increment guess(number_of_unknowns(mesh), 0.);
    return equilibrium.attempt(motion, guess);
  }
};
} // namespace

TEST(Equilibrium, NewtonConvergesQuadratically)
{
  // Residual after each iteration, by asking for less and less of them.
  std::vector<double> residuals;
  for (unsigned iterations = 2; iterations <= 8; ++iterations) {
    SolverSettings settings = solver(NonlinearMethod::newton, 1e-300);
    settings.maximum_iterations = iterations;
    Bench bench(settings);
    residuals.push_back(bench.attempt(down(4e-4)).force_residual);
  }
  unsigned quadratic = 0;
  for (std::size_t i = 0; i + 1 < residuals.size(); ++i)
    if (residuals[i] < 1e-1 && residuals[i] > 1e-6) {
      EXPECT_LT(residuals[i + 1],
                std::max(1e-12, 5 * residuals[i] * residuals[i]))
          << i;
      ++quadratic;
    }
  EXPECT_GE(quadratic, 1u);
  EXPECT_LT(residuals.back(), 1e-12);
}

TEST(Equilibrium, AndersonConvergesWithAWrongTangent)
{
  for (const double scale : {0.8, 1.7}) {
    Bench bench(solver(NonlinearMethod::anderson, 1e-6));
    bench.points.tangent_scale = scale;
    const Attempt attempt = bench.attempt(down(3e-5));
    EXPECT_TRUE(attempt.converged) << attempt.reason;
    EXPECT_LE(attempt.iterations, 12u);
  }
}

TEST(Equilibrium, BothMethodsFindTheSameState)
{
  Bench newton(solver(NonlinearMethod::newton));
  Bench anderson(solver(NonlinearMethod::anderson));
  ASSERT_TRUE(newton.attempt(down(2e-4)).converged);
  ASSERT_TRUE(anderson.attempt(down(2e-4)).converged);
  for (std::size_t i = 0; i < newton.equilibrium.increment().size(); ++i)
    EXPECT_NEAR(newton.equilibrium.increment()[i],
                anderson.equilibrium.increment()[i],
                1e-7 * 2e-4);
}

TEST(Equilibrium, LoadedPunchMatchesTheMovedOne)
{
  Bench moved(solver(NonlinearMethod::newton));
  const Attempt first = moved.attempt(down(2e-4));
  ASSERT_TRUE(first.converged);
  Bench loaded(solver(NonlinearMethod::newton));
  Motion motion;
  motion[upper_punch].loaded = true;
  motion[upper_punch].force = -first.forces[upper_punch].force[2];
  const Attempt second = loaded.attempt(motion);
  ASSERT_TRUE(second.converged) << second.reason;
  for (std::size_t i = 0; i < moved.equilibrium.increment().size(); ++i)
    EXPECT_NEAR(moved.equilibrium.increment()[i],
                loaded.equilibrium.increment()[i],
                1e-7 * 2e-4);
}

// With such a guess all nodes slip along the die, and nothing holds it.
TEST(Equilibrium, FloatingDieIsFoundFromAnyGuess)
{
  std::vector<double> places;
  for (const double guess : {-1e-4, 0., 2e-4, 2e-3}) {
    Bench bench(solver(NonlinearMethod::newton));
    ASSERT_TRUE(bench.attempt(down(1e-4)).converged);
    bench.equilibrium.accept();
    Motion motion = down(1e-4);
    motion[die_wall].loaded = true;
    motion[die_wall].displacement = guess;
    const Attempt attempt = bench.attempt(motion);
    ASSERT_TRUE(attempt.converged) << guess << ": " << attempt.reason;
    places.push_back(
        bench.equilibrium.increment()[tool_dof(bench.mesh, die_wall)]);
    EXPECT_NEAR(attempt.forces[die_wall].force[2],
                0,
                1e-9 * attempt.forces[die_wall].normal);
  }
  for (const double place : places)
    EXPECT_NEAR(place, places[0], 1e-7 * 1e-4); // of the punch's way
}

TEST(Equilibrium, FailedAttemptLeavesNoTrace)
{
  const std::vector<double> taken = {1e-4, 5e-5, 6e-5};
  Bench clean(solver(NonlinearMethod::anderson));
  for (const double distance : taken) {
    ASSERT_TRUE(clean.attempt(down(distance)).converged);
    clean.equilibrium.accept();
  }
  Bench disturbed(solver(NonlinearMethod::anderson));
  unsigned spoilt = 0;
  for (const double distance : taken) {
    disturbed.points.spoil = [&](unsigned evaluation,
                                 std::span<Response> responses) {
      if (evaluation % 3 == 0) {
        responses[5].status = Status::failed;
        responses[5].stress *= std::nan("");
        ++spoilt;
      }
    };
    const Attempt attempt = disturbed.attempt(down(2 * distance));
    EXPECT_FALSE(attempt.converged);
    EXPECT_EQ(attempt.point, 5u);
    disturbed.points.spoil = {};
    ASSERT_TRUE(disturbed.attempt(down(distance)).converged);
    disturbed.equilibrium.accept();
  }
  EXPECT_EQ(spoilt, taken.size());
  EXPECT_FALSE(disturbed.points.committed_spoilt);
  const CompactState &a = clean.press.compact().state();
  const CompactState &b = disturbed.press.compact().state();
  for (std::size_t n = 0; n < a.positions.size(); ++n)
    EXPECT_EQ(a.positions[n], b.positions[n]);
  for (std::size_t p = 0; p < a.responses.size(); ++p)
    EXPECT_EQ(a.responses[p].stress, b.responses[p].stress);
  const auto &wall = clean.press.contact().accepted();
  for (std::size_t i = 0; i < wall.size(); ++i)
    EXPECT_EQ(wall[i].force, disturbed.press.contact().accepted()[i].force);
}

// A point's stress is off by a share, up and down from trial to trial: no
// update gets the forces nearer to balance than a part of it.
TEST(Equilibrium, NearestStateIsTakenIfAnswersScatterALittle)
{
  constexpr double tolerance = 1e-4;
  SolverSettings settings = solver(NonlinearMethod::anderson, tolerance);
  settings.displacement_tolerance = 1e-2;
  const auto attempt = [&](double scatter) {
    Bench bench(settings);
    bench.points.spoil = [scatter](unsigned evaluation,
                                   std::span<Response> responses) {
      responses[5].stress *= 1 + (evaluation % 2 ? scatter : -scatter);
    };
    return bench.attempt(down(1e-4));
  };
  const Attempt smooth = attempt(0);
  EXPECT_TRUE(smooth.converged);
  EXPECT_FALSE(smooth.stagnated);
  EXPECT_LE(smooth.force_residual, tolerance);
  const Attempt scattered = attempt(1e-2);
  EXPECT_TRUE(scattered.converged) << scattered.reason;
  EXPECT_TRUE(scattered.stagnated);
  EXPECT_GT(scattered.force_residual, tolerance);
  EXPECT_LE(scattered.force_residual, 10 * tolerance);
  const Attempt wild = attempt(0.3);
  EXPECT_FALSE(wild.converged);
  EXPECT_FALSE(wild.stagnated);
}

TEST(Equilibrium, GuardRefusesAPointThatLosesWhatNobodyTookBack)
{
  Bench bench(solver(NonlinearMethod::newton));
  ASSERT_TRUE(bench.attempt(down(1e-5)).converged);
  bench.equilibrium.accept();
  const Attempt released = bench.attempt(down(-8e-6));
  ASSERT_TRUE(released.converged);
  const auto refused = [&](const OpeningLimits &limits) {
    Attempt attempt = released;
    bench.equilibrium.refuse_opening(limits, attempt);
    EXPECT_EQ(attempt.opened, !attempt.converged);
    return attempt.reason;
  };
  EXPECT_NE(refused({}).find("loses its pressure"), std::string::npos);
  // The punch took back four fifths of its force.
  EXPECT_EQ(refused({.kept_pressure = 0.2}), "");
  EXPECT_EQ(refused({.least_pressure = 1e9}), "");
}

TEST(Equilibrium, GuardRefusesAPointThatGrowsMuch)
{
  Bench bench(solver(NonlinearMethod::newton));
  ASSERT_TRUE(bench.attempt(down(1e-4)).converged);
  bench.equilibrium.accept();
  Attempt attempt = bench.attempt(down(-5e-5));
  ASSERT_TRUE(attempt.converged);
  bench.equilibrium.refuse_opening({.kept_pressure = 0}, attempt);
  EXPECT_TRUE(attempt.opened);
  EXPECT_NE(attempt.reason.find("in a step"), std::string::npos);

  attempt = bench.attempt(down(-1e-6));
  ASSERT_TRUE(attempt.converged);
  std::vector<double> densities;
  for (const Response &response : bench.press.compact().state().responses)
    densities.push_back(response.relative_density);
  bench.equilibrium.refuse_opening({.densities = densities}, attempt);
  EXPECT_FALSE(attempt.opened);
  densities[2] *= 1.06;
  bench.equilibrium.refuse_opening({.densities = densities}, attempt);
  EXPECT_TRUE(attempt.opened);
  EXPECT_EQ(attempt.point, 2u);
  EXPECT_NE(attempt.reason.find("since the ejection"), std::string::npos);
}
} // namespace tamp::fem
