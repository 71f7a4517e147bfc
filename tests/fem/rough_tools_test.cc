// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/elastic.h>
#include <tests/fem/die_bench.h>
#include <tests/fem/die_run.h>

namespace tamp::fem
{
namespace
{
using namespace test;

DieSettings rough_die(PunchFace::Kind kind, double friction)
{
  DieSettings settings = frictionless_die(6, 6);
  PunchFace &face = settings.geometry.upper_face;
  face.kind = kind;
  face.radius = 8e-3;
  face.width = 2e-3;
  face.angle = 0.5;
  for (const Tool tool : {die_wall, upper_punch, lower_punch})
    settings.friction[tool] = FrictionCoefficient(friction);
  return settings;
}
} // namespace

// From rest every node must find out whether it sticks, slips or lifts off, and
// which way: the first guess is wrong at most of them.
TEST(RoughTools, LargeFirstStepNeedsNoCut)
{
  using Kind = PunchFace::Kind;
  for (const double friction : {0.1, 0.2, 0.4, 0.6})
    for (const double share : {0.005, 0.014, 0.03})
      for (const Kind kind : {Kind::convex, Kind::concave, Kind::bevel}) {
        const DieSettings settings = rough_die(kind, friction);
        DieBench bench(settings, Elastic(ElasticParameters{}));
        Motion motion;
        motion[upper_punch].displacement =
            -share * settings.geometry.fill_height;
        const Attempt attempt = bench.attempt(motion);
        EXPECT_TRUE(attempt.converged)
            << "friction " << friction << ", strain " << share << ", face "
            << static_cast<int>(kind) << ": " << attempt.reason;
      }
}
} // namespace tamp::fem
