// SPDX-License-Identifier: BSD-3-Clause
#include <tests/fem/die_bench.h>
#include <tests/fem/die_run.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tamp::fem
{
namespace
{
using namespace test;

constexpr double pi = std::numbers::pi;
constexpr double modulus = 1e9; // Young's [Pa]

/// Highest and outermost node [m].
double top_of(const NodePositions &positions)
{
  double top = 0;
  for (const auto &x : positions)
    top = std::max(top, x[2]);
  return top;
}
double bottom_of(const NodePositions &positions)
{
  double bottom = 1;
  for (const auto &x : positions)
    bottom = std::min(bottom, x[2]);
  return bottom;
}
} // namespace

// Hooke's law in logarithmic strains e = ln(h / H) at constant radius: sigma_z
// = M e, sigma_r = k sigma_z with k = nu / (1 - nu).
TEST(OneElement, PressesAndUnloadsElasticallyAsTheClosedForm)
{
  constexpr double nu = 0.3, k = nu / (1 - nu);
  constexpr double M = modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  // Forces are balanced to 1e-9.
  constexpr double tolerance = 1e-8;
  DieSettings settings = frictionless_die(1, 1);
  settings.stages = {press_down(3e-4),
                     {StageKind::unload, StageTarget::nothing}};
  const DieRun run(settings, elastic_law(modulus, nu));
  const double R = settings.geometry.radius;
  double peak = 0;
  for (const StepRecord &record : run.records) {
    if (record.upper_force <= 0)
      continue;
    const double h = settings.geometry.fill_height - record.upper_displacement;
    const double stress = M * std::log(settings.geometry.fill_height / h);
    peak = std::max(peak, stress);
    EXPECT_NEAR(record.upper_force, pi * R * R * stress, tolerance * M * R * R);
    EXPECT_NEAR(record.lower_force, record.upper_force, tolerance * M * R * R);
    EXPECT_NEAR(record.wall_normal_force,
                2 * pi * R * h * k * stress,
                tolerance * M * R * h);
  }
  EXPECT_GT(peak, 0.04 * M);
  const StepRecord &last = run.last();
  const double peak_force = pi * R * R * peak;
  EXPECT_EQ(last.upper_force, 0);
  EXPECT_NEAR(last.lower_force, 0, tolerance * peak_force);
  EXPECT_NEAR(last.wall_normal_force, 0, tolerance * peak_force);
  EXPECT_NEAR(
      last.compact_height / settings.geometry.fill_height, 1, tolerance);
}

// A compact with a radial stress -s that stands in the die free of axial load,
// as after plastic pressing and unloading, is pushed out: the force is mu s 2
// pi R H while it is inside. Outside it is free, and Hooke's law gives
// logarithmic strains s (1 - nu) / E along the radius, -2 nu s / E along the
// axis.
TEST(OneElement, EjectsAndSpringsBackAsTheClosedForm)
{
  constexpr double s = 1e6, mu = 0.1;
  // Friction shortens the compact by about mu s / E: so much less wall.
  constexpr double shortening = 3 * mu * s / modulus;
  // Where nu is not zero, axial stresses of 2 mu s H / R times nu / (1 - nu)
  // add to s.
  for (const double nu : {0., 0.3}) {
    DieSettings settings = frictionless_die(1, 1);
    settings.friction[die_wall] = FrictionCoefficient(mu);
    // Where no force is left, 1e-6 of the peak. Elsewhere the displacements
    // have to settle, which balances forces much better.
    settings.solver.force_tolerance = 1e-2;
    settings.solver.displacement_tolerance = 1e-6;
    const double R = settings.geometry.radius,
                 H = settings.geometry.fill_height;
    const double by_axial = 2 * mu * H / R * nu / (1 - nu);
    DieBench bench(settings, elastic_law(modulus, nu, -s));
    bench.move(-3e-3, -3e-3); // into the die
    bench.move(2e-2, 0);      // the upper punch leaves
    EXPECT_EQ(bench.forces()[upper_punch].normal, 0);
    const double F = mu * s * 2 * pi * R * H;
    unsigned inside = 0, steps = 0;
    while (bottom_of(bench.positions()) < H + 0.6 * H && ++steps < 20) {
      bench.move(1e-3, 1e-3);
      const double top = top_of(bench.positions());
      const double force = bench.forces()[lower_punch].force[2];
      if (top < H) {
        ++inside;
        EXPECT_NEAR(
            force / mu / bench.forces()[die_wall].normal, 1, 1e-8); // balance
        EXPECT_NEAR(force / F, 1, shortening + by_axial);
      }
    }
    EXPECT_GE(inside, 2u);
    bench.move(0, 0);
    // As balanced as the solver is asked for.
    for (const ToolForce &tool : bench.forces())
      EXPECT_NEAR(tool.force.norm(), 0, 1e-6 * F);
    double radius = 0;
    for (const auto &x : bench.positions())
      radius = std::max(radius, x[0]);
    const double height =
        top_of(bench.positions()) - bottom_of(bench.positions());
    constexpr double tolerance = 1e-5; // of the largest strain
    EXPECT_NEAR(
        std::log(radius / R), s * (1 - nu) / modulus, tolerance * s / modulus);
    EXPECT_NEAR(
        std::log(height / H), -2 * nu * s / modulus, tolerance * s / modulus);
    for (const Response &response : bench.responses())
      EXPECT_LT(response.stress.norm(), tolerance * s);
  }
}

TEST(OneElement, WorkOfAnEjectionIsWhatRubsLessWhatTheCompactReleases)
{
  // As above, with strains so small that their squares do not count.
  constexpr double s = 1e4, mu = 0.1, strain = s / modulus;
  constexpr double closes = 1e-8; // forces are balanced better than that
  for (const double nu : {0., 0.3}) {
    DieSettings settings = frictionless_die(1, 1);
    settings.friction[die_wall] = FrictionCoefficient(mu);
    settings.solver.force_tolerance = 1e-2; // as above
    settings.solver.displacement_tolerance = 1e-11;
    const double R = settings.geometry.radius,
                 H = settings.geometry.fill_height, way = 1e-3;
    DieBench bench(settings, elastic_law(modulus, nu, -s));
    bench.move(-3e-3, -3e-3); // into the die
    bench.move(2e-2, 0);      // the upper punch leaves
    bench.move(way, way);     // friction turns
    EXPECT_LT(bench.press.work().residual(), closes);
    unsigned inside = 0, steps = 0;
    while (bottom_of(bench.positions()) < H + 0.6 * H && ++steps < 20) {
      const WorkAccount before = bench.press.work();
      bench.move(way, way);
      const WorkAccount &now = bench.press.work();
      EXPECT_LT(now.residual(), closes);
      if (top_of(bench.positions()) >= H)
        continue;
      ++inside; // where the wall bears mu s 2 pi R H, and more if nu > 0
      const double by_axial = 2 * mu * H / R * nu / (1 - nu);
      const double rubbed = mu * s * 2 * pi * R * H * way;
      EXPECT_NEAR(
          (now.tools - before.tools) / rubbed, 1, 3 * mu * strain + by_axial);
      EXPECT_NEAR(
          now.lost - before.lost, now.tools - before.tools, closes * now.tools);
    }
    EXPECT_GE(inside, 1u);
    bench.move(0, 0);
    // What was stored in the die: V s^2 (1 - nu) / E.
    const double stored = pi * R * R * H * s * s * (1 - nu) / modulus;
    const WorkAccount &work = bench.press.work();
    EXPECT_NEAR(work.powder / stored, -1, strain);
    EXPECT_NEAR(work.lost, work.tools + stored, closes * work.tools);
  }
}

namespace
{
/// Friction of one element over half the normal force of the wall: the lower
/// node rests on its punch and does not slip. In an increment density is that
/// of its start, the area of the wall too.
struct Reading {
  double coefficient, density, pressure;
};

std::vector<Reading> readings(const FrictionCoefficient &friction)
{
  DieSettings settings = frictionless_die(1, 1);
  settings.friction[die_wall] = friction;
  settings.stages = {press_down(3e-4)};
  const DieRun run(settings, elastic_law(modulus, 0.3));
  std::vector<Reading> result;
  const double R = settings.geometry.radius;
  double height = settings.geometry.fill_height, density = 0.5;
  for (const StepRecord &record : run.records) {
    result.push_back(
        {record.wall_friction_force / (0.5 * record.wall_normal_force),
         density,
         record.wall_normal_force / (2 * pi * R * height)});
    height = record.compact_height;
    density = record.mean_relative_density;
  }
  EXPECT_GT(result.size(), 5u);
  return result;
}

constexpr double balanced = 1e-8; // forces are, to 1e-9
} // namespace

TEST(OneElement, FrictionFollowsItsTableOverDensity)
{
  // From 0.6 at 0.50 to 0.2 at 0.52, then constant.
  const DensityTable table({{0.5, 0.52}, {0.6, 0.2}}, "friction");
  const auto found = readings({FrictionCoefficient::Of::density, table});
  for (const Reading &reading : found)
    EXPECT_NEAR(reading.coefficient,
                std::max(0.2, 0.6 - 20 * (reading.density - 0.5)),
                balanced);
  EXPECT_EQ(found.front().density, 0.5);
  EXPECT_GT(found.back().density, 0.52);
}

TEST(OneElement, FrictionFollowsItsTableOverPressure)
{
  // From 0.5 without pressure to 0.1 at 10 MPa, then constant.
  const DensityTable table({{0, 10e6}, {0.5, 0.1}}, "friction");
  const auto found = readings({FrictionCoefficient::Of::pressure, table});
  for (const Reading &reading : found)
    EXPECT_NEAR(reading.coefficient,
                std::max(0.1, 0.5 - 0.04e-6 * reading.pressure),
                balanced);
  EXPECT_LT(found.front().pressure, 1e6);
  EXPECT_GT(found.back().pressure, 10e6);
}
} // namespace tamp::fem
