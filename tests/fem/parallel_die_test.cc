// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <tests/fem/same_everywhere.h>
#include <tests/fem/solver_cases.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tamp::fem
{
namespace
{
constexpr double force_tolerance = 1e-8; ///< of every step, of the reactions

/// What a run leaves: the forces, densities and sizes of every step, and all
/// points at its end.
struct Curve {
  std::vector<double> forces, densities, lengths;
  std::vector<double> positions, point_densities;
  Advance end = Advance::stepped;
  std::size_t steps = 0;

  void take(const StepRecord &now)
  {
    forces.insert(forces.end(),
                  {now.upper_force,
                   now.lower_force,
                   now.wall_friction_force,
                   now.wall_normal_force});
    densities.insert(densities.end(),
                     {now.mean_relative_density,
                      now.minimum_relative_density,
                      now.maximum_relative_density});
    lengths.insert(lengths.end(),
                   {now.upper_displacement,
                    now.lower_displacement,
                    now.compact_height,
                    now.compact_radius});
    ++steps;
  }

  void take_points(const DieModel &model)
  {
    for (unsigned axis = 0; axis < 3; ++axis) {
      std::vector<double> own;
      for (const auto &position : model.point_positions())
        own.push_back(position[axis]);
      const auto all = model.whole(own);
      positions.insert(positions.end(), all.begin(), all.end());
    }
    std::vector<double> own;
    for (const Response &response : model.responses())
      own.push_back(response.relative_density);
    point_densities = model.whole(own);
  }
};

Curve press(const DieSettings &settings, const Ranks &ranks)
{
  const Mesh mesh = build_mesh(settings.geometry);
  ContinuumPoints<DruckerPragerCap> points(
      DruckerPragerCap(),
      ranks.share(mesh.number_of_cells()).size() * mesh.points_per_cell());
  DieModel model(settings, mesh, points, {}, ranks);
  Curve curve;
  curve.take(model.last_step());
  while ((curve.end = model.advance()) == Advance::stepped)
    curve.take(model.last_step());
  curve.take_points(model);
  return curve;
}

/// Avicel PH-102, pressed against wall friction, unloaded, pushed up and, in
/// part, out.
DieSettings small_die(Section section)
{
  DieSettings settings;
  settings.geometry.section = section;
  const bool quarter = section == Section::quarter;
  settings.geometry.shape = quarter ? DieShape::square : DieShape::cylinder;
  settings.geometry.radial_elements = 2;
  settings.geometry.axial_elements = quarter ? 3 : 4;
  settings.stages = {{StageKind::press, StageTarget::displacement, 1e-3},
                     {StageKind::unload, StageTarget::nothing},
                     {StageKind::eject, StageTarget::displacement, 2e-3, 0}};
  settings.steps.first = settings.steps.maximum = quarter ? 5e-2 : 3e-2;
  settings.steps.unloading = quarter ? 2e-2 : 1e-2;
  settings.steps.rim = 0.5;
  settings.solver.method = NonlinearMethod::newton;
  settings.solver.force_tolerance = force_tolerance;
  settings.solver.linear.method = LinearMethod::direct;
  return settings;
}

/// The largest difference over the largest value.
double difference(const std::vector<double> &one,
                  const std::vector<double> &other)
{
  EXPECT_EQ(one.size(), other.size());
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
    worst = std::max(worst, std::abs(one[i] - other[i]));
    largest = std::max(largest, std::abs(one[i]));
  }
  return worst / largest;
}

void expect_same(const Curve &curve, const Curve &reference, double tolerance)
{
  EXPECT_EQ(curve.end, Advance::finished);
  EXPECT_EQ(reference.end, Advance::finished);
  ASSERT_EQ(curve.steps, reference.steps);
  EXPECT_LT(difference(curve.forces, reference.forces), tolerance);
  EXPECT_LT(difference(curve.densities, reference.densities), tolerance);
  EXPECT_LT(difference(curve.lengths, reference.lengths), tolerance);
  EXPECT_LT(difference(curve.positions, reference.positions), tolerance);
  EXPECT_LT(difference(curve.point_densities, reference.point_densities),
            tolerance);
}

class ParallelDie : public testing::TestWithParam<LinearSettings>
{
protected:
  void expect_curve_of_one_rank(Section section) const
  {
    DieSettings settings = small_die(section);
    const Curve reference = press(settings, Ranks(MPI_COMM_SELF));
    settings.solver.linear = GetParam();
    const Curve curve = press(settings, ranks);
    for (const auto *values : {&curve.forces,
                               &curve.densities,
                               &curve.lengths,
                               &curve.positions,
                               &curve.point_densities})
      EXPECT_TRUE(test::same_everywhere(*values, ranks));
    // Rounding, through every Newton step; of inexact Newton steps what they
    // leave in each step of the run.
    const auto steps = static_cast<double>(reference.steps);
    expect_same(curve,
                reference,
                test::is_direct(GetParam()) ? 1e-9 : steps * force_tolerance);
    expect_trip(curve);
  }

  // It was pressed and pushed against friction, and left by the punch.
  static void expect_trip(const Curve &curve)
  {
    double peak = 0, most = 0, least = 0;
    for (std::size_t i = 0; i < curve.forces.size(); i += 4) {
      peak = std::max(peak, curve.forces[i]);
      most = std::max(most, curve.forces[i + 2]);
      least = std::min(least, curve.forces[i + 2]);
    }
    EXPECT_GT(most, 1e-2 * peak);
    EXPECT_LT(least, -1e-2 * peak);
    EXPECT_EQ(curve.forces[4 * (curve.steps - 1)], 0);
    const double pushed = curve.lengths[4 * (curve.steps - 1) + 1];
    EXPECT_NEAR(pushed, 2e-3, 1e-9); // rounding of the schedule
  }

  const Ranks ranks = Ranks(MPI_COMM_WORLD);
};
INSTANTIATE_TEST_SUITE_P(All,
                         ParallelDie,
                         test::all_solvers(),
                         test::solver_name);
} // namespace

TEST_P(ParallelDie, AxisymmetricHasTheCurveOfOneRankAndADirectSolver)
{
  expect_curve_of_one_rank(Section::axisymmetric);
}

TEST_P(ParallelDie, QuarterHasTheCurveOfOneRankAndADirectSolver)
{
  expect_curve_of_one_rank(Section::quarter);
}
} // namespace tamp::fem
