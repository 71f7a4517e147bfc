// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/density_table.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/mcc_ph102.h>
#include <fem/laws/modified_cam_clay.h>
#include <tests/fem/laws/rate_reference.h>

#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <random>
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
  return worst_difference(points,
                          RateReference(CamClayRates{parameters}),
                          {start.stress,
                           start.relative_density,
                           start.yield_pressure},
                          legs);
}

/// Compressed isotropically to the yield pressure and beyond.
Points compressed(const double strain)
{
  auto points = one_point();
  EXPECT_TRUE(
      follow(points, leg({-strain, -strain, -strain, 0, 0, 0}, 50)));
  return points;
}

TEST(ModifiedCamClay, Explore)
{
  for (double tolerance : {1e-3, 1e-4, 1e-5}) {
    ModifiedCamClayParameters c;
    c.tolerance = tolerance;
    std::cout << tolerance << " prop "
              << difference({leg({-.2, -.1, -.3, 0, 0, 0}, 30)}, c) << " uni "
              << difference({leg({0, 0, -.7, 0, 0, 0}, 70),
                             leg({0, 0, .05, 0, 0, 0}, 10),
                             leg({0, 0, -.1, 0, 0, 0}, 10)},
                            c)
              << " shear "
              << difference({leg({-.1, -.1, -.1, 0, 0, 0}, 20),
                             leg({0, 0, 0, .2, 0, 0}, 20),
                             leg({-.02, .02, 0, 0, .2, 0}, 20),
                             leg({0, 0, 0, -.2, 0, .1}, 20)},
                            c)
              << std::endl;
  }
  auto points = compressed(.2);
  const auto r = newton_residuals(points, -0.02, points.state(0).stress[0][0]);
  for (double x : r)
    std::cout << x << " ";
  std::cout << newton_order(r, 1e-3) << std::endl;
}
} // namespace
} // namespace tamp::fem
