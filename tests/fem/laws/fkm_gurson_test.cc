// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/fkm_gurson.h>
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
using Points = ContinuumPoints<FkmGurson>;

Points one_point(const FkmGursonParameters &parameters = {})
{
  return Points(FkmGurson(parameters), 1);
}

/// F at p, q and density, written anew from the published forms.
double published(const FkmGursonParameters &c,
                 const double p,
                 const double q,
                 const double D)
{
  const double s = c.solid_yield_stress, f = 1 - D;
  const double p_y = 2.97 * D * D * s * (D - 0.64) / 0.36;
  const double a = c.vertex_rounding * p_y, top = 1.2 * p_y;
  const double r = (std::hypot(q, a) - a) * top / (std::hypot(top, a) - a);
  const double fkm = std::pow(std::sqrt(5) * p / (3 * p_y), 2) +
                     std::pow(5 * r / (18 * p_y) + 2. / 3, 2) - 1;
  const double gurson =
      q * q / (s * s) + 2 * f * std::cosh(1.5 * p / s) - 1 - f * f;
  const double x = std::clamp((D - 0.77) / 0.13, 0., 1.);
  const double w = x * x * (3 - 2 * x);
  return w <= 0 ? fkm : w >= 1 ? gurson : (1 - w) * fkm + w * gurson;
}

/// The law's rate equations; the gradient by differences.
struct FkmGursonRates {
  FkmGursonParameters c;
  RateCoefficients operator()(const double p,
                              const double q,
                              double,
                              const double D) const
  {
    const double E = c.solid_youngs_modulus *
                     std::exp(-c.elastic_exponent * (1 - D));
    const double nu = c.solid_poissons_ratio;
    const double h = 1e-5 * c.solid_yield_stress, d = 1e-6;
    return {E / (3 * (1 - 2 * nu)),
            E / (2 * (1 + nu)),
            published(c, p, q, D),
            (published(c, p + h, q, D) - published(c, p - h, q, D)) / (2 * h),
            (published(c, p, q + h, D) - published(c, p, q - h, D)) / (2 * h),
            (published(c, p, q, D + d) - published(c, p, q, D - d)) / (2 * d),
            D};
  }
};

double difference(const std::vector<Leg> &legs,
                  const FkmGursonParameters &parameters = {})
{
  auto points = one_point(parameters);
  const auto &start = points.state(0);
  return worst_difference(
      points,
      RateReference(FkmGursonRates{parameters}),
      {start.stress, start.relative_density, 1 - start.porosity},
      legs);
}

TEST(FkmGurson, Explore)
{
  for (double tolerance : {1e-3, 1e-4, 1e-5}) {
    FkmGursonParameters c;
    c.tolerance = tolerance;
    std::cout << tolerance << " prop "
              << difference({leg({-.1, -.05, -.15, 0, 0, 0}, 30)}, c) << " uni "
              << difference({leg({0, 0, -.35, 0, 0, 0}, 70),
                             leg({0, 0, .01, 0, 0, 0}, 10),
                             leg({0, 0, -.05, 0, 0, 0}, 10)},
                            c)
              << " shear "
              << difference({leg({-.05, -.05, -.05, 0, 0, 0}, 20),
                             leg({0, 0, 0, .05, 0, 0}, 20),
                             leg({-.02, .02, 0, 0, .05, 0}, 20),
                             leg({0, 0, 0, -.05, 0, .03}, 20)},
                            c)
              << std::endl;
  }
  auto points = one_point();
  EXPECT_TRUE(follow(points, leg({-.03, -.03, -.06, 0, 0, 0}, 20)));
  const auto r = newton_residuals(points, -0.01, points.state(0).stress[0][0]);
  for (double x : r)
    std::cout << x << " ";
  std::cout << newton_order(r, 1e-3) << std::endl;
}
} // namespace
} // namespace tamp::fem
