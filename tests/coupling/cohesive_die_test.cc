// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <tests/coupling/cell_bench.h>
#include <tests/coupling/sample_cells.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace tamp::coupling
{
namespace
{
using fem::StageKind;
using fem::StageTarget;

/// A fine powder of the kind of organic crystals, at 1 MPa.
dem::PackingRequest fine_powder(double work_of_adhesion)
{
  dem::PackingRequest request;
  request.grain_count = 60;
  request.goal.pressure = 1e6;
  request.material = {5e9, 0.3, 1300, 50e6};
  request.contact.normal_law = dem::NormalLaw::thornton_ning_jkr;
  request.contact.friction_coefficient = 0.35;
  request.contact.work_of_adhesion = work_of_adhesion;
  request.sizes.minimum_diameter = 4e-6;
  request.sizes.maximum_diameter = 6e-6;
  return request;
}

/// Pressed, released, and pushed out of a die whose wall rubs.
fem::DieSettings free_die()
{
  fem::DieSettings settings;
  settings.geometry.radial_elements = 1;
  settings.geometry.axial_elements = 2;
  settings.friction[fem::die_wall] = fem::FrictionCoefficient(0.2);
  settings.stages = {
      {StageKind::press, StageTarget::density, 0.63},
      {StageKind::unload, StageTarget::nothing, 0},
      {StageKind::eject, StageTarget::out, 0, 0},
  };
  settings.steps.maximum = 1e-2;
  settings.steps.unloading = 2e-3;
  settings.steps.rim = 0.5;
  settings.solver.guard_against_opening = true;
  settings.solver.least_reaction = 0.1;
  return settings;
}

/// A run of cells with packings of their own.
struct PressedPowder {
  fem::DieSettings settings;
  fem::Mesh mesh = fem::build_mesh(settings.geometry);
  UnitCellPoints cells;
  fem::DieModel die;
  std::vector<dealii::Tensor<1, 3>> start = die.point_positions();
  std::vector<fem::StepRecord> records;

  explicit PressedPowder(double work_of_adhesion)
      : settings(free_die()),
        cells(test::first_packings(fine_powder(work_of_adhesion),
                                   mesh.number_of_points()),
              {}),
        die(settings, mesh, cells)
  {
  }

  fem::Advance go()
  {
    fem::Advance advance = fem::Advance::stepped;
    while ((advance = die.advance()) == fem::Advance::stepped)
      records.push_back(die.last_step());
    return advance;
  }

  const fem::StepRecord &last_of(unsigned stage) const
  {
    return *std::find_if(records.rbegin(), records.rend(), [&](const auto &r) {
      return r.stage == stage;
    });
  }

  /// Mean of the stress over the compact, each point with its volume [Pa].
  dealii::SymmetricTensor<2, 3> mean_stress() const
  {
    // Gauss points of equal rectangles: their volumes were as their distances
    // from the axis.
    dealii::SymmetricTensor<2, 3> sum;
    double volume = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const double part =
          start[i][0] * determinant(die.deformation_gradients()[i]);
      sum += part * die.responses()[i].stress;
      volume += part;
    }
    return sum / volume;
  }
};
} // namespace

TEST(CohesiveDie, ACompactThatIsReleasedAndEjectedSpringsBackAndIsFree)
{
  PressedPowder run(0.1);
  ASSERT_EQ(run.go(), fem::Advance::finished) << run.die.failure().reason;
  const fem::StepRecord &peak = run.last_of(0), &released = run.last_of(1),
                        &out = run.last_of(2);
  EXPECT_EQ(released.upper_force, 0);
  EXPECT_GT(released.compact_height, peak.compact_height);
  // Friction holds it in the die, with a good part of the peak's wall force.
  EXPECT_GT(released.wall_normal_force, 0.05 * peak.wall_normal_force);
  EXPECT_LT(released.wall_normal_force, 0.5 * peak.wall_normal_force);
  for (const double force :
       {out.upper_force, out.lower_force, out.wall_normal_force})
    EXPECT_NEAR(force, 0, 1e-4 * peak.upper_force); // the tolerance
  // Both as of a compact that holds together: some per cent at most.
  const double wide = out.compact_radius / peak.compact_radius - 1;
  const double high = out.compact_height / peak.compact_height - 1;
  EXPECT_GT(wide, 1e-3);
  EXPECT_LT(wide, 0.02);
  EXPECT_GT(high, released.compact_height / peak.compact_height - 1);
  EXPECT_LT(high, 0.06);
  // Nothing pulls at a free body, so its stresses cancel in the mean. What is
  // unbalanced at each of nine nodes may be 1e-4 of the forces of the peak.
  const double pressure = peak.upper_force / peak.punch_area;
  const auto mean = run.mean_stress();
  EXPECT_NEAR(mean[2][2], 0, 1e-3 * pressure);
  EXPECT_NEAR(mean[0][0] + mean[1][1], 0, 1e-3 * pressure);
  double largest = 0;
  for (const fem::Response &response : run.die.responses())
    largest = std::max(largest, response.stress.norm());
  EXPECT_GT(largest, 0.01 * pressure);
}

TEST(CohesiveDie, AStateOfGrainsThatPartedDoesNotPass)
{
  const fem::DieSettings settings = free_die();
  test::CellBench bench(
      settings, test::different_cells(8), CellPointsOptions());
  // Half a per cent down, then three up: nothing touches any more, and no
  // force is out of balance.
  bench.press_by(0.005 * settings.geometry.fill_height);
  fem::Attempt attempt =
      bench.attempt(-0.03 * settings.geometry.fill_height, bench.equilibrium);
  // Though the punch took all of its force back.
  if (attempt.converged)
    bench.equilibrium.refuse_opening({0, 0, 0, {}}, attempt);
  EXPECT_FALSE(attempt.converged);
}
} // namespace tamp::coupling
