// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/agcusnin.h>
#include <fem/laws/drucker_prager_cap.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace tamp::fem
{
namespace
{
/// Plastic work of flow at a point of the shear line or arc, over the product
/// of the sizes of stress and flow.
double plastic_work(const CapSurface<double> &surface, const double p)
{
  const double q = surface.shear_limit(p);
  const auto flow = surface.flow(p, q);
  return (p * flow.compaction + q * flow.shear) /
         (std::hypot(p, q) * std::hypot(flow.compaction, flow.shear));
}

/// The smallest between apex and cap.
double least_work(const CapSurface<double> &surface)
{
  double least = 1;
  for (unsigned i = 1; i <= 1000; ++i)
    least = std::min(
        least,
        plastic_work(surface,
                     surface.apex() +
                         i / 1000. * (surface.centre - surface.apex())));
  return least;
}

CapSurface<double> metal(const double density, const Dilation dilation)
{
  auto parameters = agcusnin::parameters();
  parameters.dilation = dilation;
  return DruckerPragerCap(parameters)
      .surface(std::log(density / parameters.reference_density));
}

TEST(BoundedDilation, PlasticWorkIsPositiveAlongTheShearLine)
{
  for (double density = 0.45; density < 0.9; density += 0.05)
    EXPECT_GT(least_work(metal(density, Dilation::bounded)), 0) << density;
  DruckerPragerCapParameters cellulose;
  cellulose.dilation = Dilation::bounded;
  for (double density = 0.35; density < 0.9; density += 0.05)
    EXPECT_GT(least_work(DruckerPragerCap(cellulose).surface(
                  std::log(density / cellulose.reference_density))),
              0)
        << density;
}

TEST(FullDilation, GivesOutEnergyWhereCohesionIsSmall)
{
  // With c = 1: where p_a tan(beta) > (2 + sqrt(8)) d.
  const double d = 1, tan_beta = 2, threshold = (2 + std::sqrt(8.)) * d;
  for (const double share : {0.99, 1.01}) {
    const double p_a = share * threshold / tan_beta, R = 0.5;
    const CapSurface<double> surface(
        {d, std::atan(tan_beta), R, p_a + R * (d + p_a * tan_beta)});
    EXPECT_EQ(least_work(surface) < 0, share > 1) << share;
  }
  EXPECT_LT(least_work(metal(0.85, Dilation::full)), -0.1);
}

TEST(BoundedDilation, HasTheLimitsOfFullDilation)
{
  const auto full = metal(0.85, Dilation::full),
             bounded = metal(0.85, Dilation::bounded);
  EXPECT_EQ(bounded.dilation(bounded.centre, bounded.top()), 0);
  // Towards the apex flow turns to pure dilation.
  const double p = bounded.apex() * (1 - 1e-6), q = bounded.shear_limit(p);
  EXPECT_LT(q, 1e-5 * bounded.cohesion);
  const auto flow = bounded.flow(p, q);
  EXPECT_LT(flow.shear, 1e-5 * -flow.compaction);
  // In between it is less than full dilation and than associated flow.
  const double middle = 0.5 * bounded.centre,
               limit = bounded.shear_limit(middle);
  EXPECT_LT(bounded.dilation(middle, limit), full.dilation(middle, limit));
  EXPECT_LT(bounded.dilation(middle, limit),
            bounded.tan_beta * bounded.flow(middle, limit).shear);
}
} // namespace
} // namespace tamp::fem
