// SPDX-License-Identifier: BSD-3-Clause
#include <tests/fem/die_run.h>

#include <cmath>
#include <iostream>

namespace tamp::fem
{
namespace
{
using namespace test;

/// Pressure on the lower punch over that on the upper one, of an elastic column
/// as high as wide that is pressed by a small strain: the wall slips from the
/// first step on. @param elements  along the radius
double transmission(double mu, double poissons_ratio, unsigned elements)
{
  DieSettings settings = frictionless_die(elements, 2 * elements);
  settings.geometry.fill_height = 2 * settings.geometry.radius;
  settings.friction[die_wall] = FrictionCoefficient(mu);
  settings.stages = {press_down(1e-3 * settings.geometry.fill_height)};
  const DieRun run(settings, elastic_law(1e9, poissons_ratio));
  const StepRecord &last = run.last();
  EXPECT_LE(last.wall_friction_force,
            mu * last.wall_normal_force * (1 + 1e-9)); // rounding
  return last.lower_force / last.upper_force;
}
} // namespace

// H. A. Janssen (1895) and D. M. Walker (1966) for a column of height H and
// diameter D: exp(-4 mu k H / D), with k = nu / (1 - nu) of an elastic body
// that cannot widen. They take the stress as uniform across the column. In the
// column the axial stress varies over the radius by (mu k)^2 M / G, with M / G
// = 3.5 here, from the shear that friction needs, so k of the means is up to 2
// % off: what is left on a fine mesh. On a coarse one the lowest node of the
// wall, which rests on the punch and does not slip, has more weight.
TEST(DieModel, PressureFallsAlongTheWallAsJanssenAndWalkerSay)
{
  constexpr double finest = 0.02, nu = 0.3, k = nu / (1 - nu);
  for (const double mu_k : {0.05, 0.10, 0.15}) {
    const double expected = std::exp(-4 * mu_k);
    double last = 1;
    for (const unsigned elements : {4u, 8u, 16u}) {
      const double found = transmission(mu_k / k, nu, elements);
      const double error = std::abs(found / expected - 1);
      std::cout << "mu k " << mu_k << ", " << elements << " x " << 2 * elements
                << " elements: " << found << ", slab " << expected << ", error "
                << error << "\n";
      EXPECT_LT(error, 0.7 * last);
      last = error;
    }
    EXPECT_LT(last, finest);
  }
}
} // namespace tamp::fem
