// SPDX-License-Identifier: BSD-3-Clause
#include <tests/fem/die_run.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace tamp::fem
{
namespace
{
using namespace test;

struct Exit {
  double largest_tension = 0; ///< axial, of any point on the way out [Pa]
  double last_forces = 0;     ///< of the tools, largest [N]
  double peak_force = 0;      ///< of the lower punch while ejecting [N]
};

/// An elastic compact with a radial stress of -10 MPa is pressed a little, set
/// free and ejected through a bore whose last 2 mm widen at this angle [rad].
Exit eject(double angle)
{
  DieSettings settings = frictionless_die(4, 12);
  settings.geometry.exit_taper_angle = angle;
  settings.geometry.exit_taper_length = angle > 0 ? 2e-3 : 0;
  settings.friction[die_wall] = FrictionCoefficient(0.1);
  settings.solver.force_tolerance = 1e-6;
  settings.solver.displacement_tolerance = 1e-6;
  Stage out{StageKind::eject, StageTarget::out, 0, 0};
  settings.stages = {press_down(1e-4), out};
  const Mesh mesh = build_mesh(settings.geometry);
  ContinuumPoints<Elastic> points(elastic_law(1e9, 0.2, -1e7),
                                  mesh.number_of_points());
  DieModel model(settings, mesh, points);
  Exit result;
  Advance advance = Advance::stepped;
  unsigned cuts = 0, steps = 0;
  while ((advance = model.advance()) == Advance::stepped) {
    const StepRecord &record = model.last_step();
    cuts += record.cuts;
    ++steps;
    if (record.stage == 1) {
      result.peak_force = std::max(result.peak_force, record.lower_force);
      for (const Response &response : model.responses())
        result.largest_tension =
            std::max(result.largest_tension, response.stress[2][2]);
    }
    result.last_forces = std::max({std::abs(record.upper_force),
                                   std::abs(record.lower_force),
                                   record.wall_normal_force});
  }
  EXPECT_EQ(advance, Advance::finished) << model.failure().reason;
  std::cout << "taper " << angle << " rad: largest tension "
            << result.largest_tension << " Pa, ejection force "
            << result.peak_force << " N, " << steps << " steps\n";
  EXPECT_EQ(cuts, 0u);
  return result;
}
} // namespace

TEST(DieModel, AnExitTaperReleasesTheCompactGradually)
{
  const Exit sharp = eject(0);
  const Exit tapered = eject(0.02);
  // The corner of the rim bends the compact, the taper spreads the bend.
  EXPECT_LT(tapered.largest_tension, 0.8 * sharp.largest_tension);
  EXPECT_LT(tapered.peak_force, sharp.peak_force);
  for (const Exit &exit : {sharp, tapered}) {
    EXPECT_GT(exit.largest_tension, 0);
    EXPECT_LT(exit.last_forces, 1e-6 * exit.peak_force); // the tolerance
  }
}
} // namespace tamp::fem
