// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/continuum_points.h>
#include <fem/laws/elastic.h>
#include <fem/laws/mcc_ph102.h>
#include <fem/path_driver.h>

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
constexpr double E = 2e9, nu = 0.3;

ElasticParameters constants()
{
  ElasticParameters parameters;
  parameters.elasticity = {E, nu};
  return parameters;
}

/// The end of a path of strains in xx, yy, zz.
Response end_of(const ElasticParameters &parameters,
                const std::array<double, 3> &strain,
                const double increment)
{
  ContinuumPoints<Elastic> points(Elastic(parameters), 1);
  PathStage stage;
  for (unsigned i = 0; i < 3; ++i)
    stage.components[i].value = strain[i];
  stage.maximum_increment = increment;
  Response last;
  EXPECT_EQ(
      drive_path(points,
                 {stage},
                 {},
                 [&](const PathRecord &record) { last = record.response; }),
      PathEnd::finished);
  return last;
}

TEST(Elastic, ConstantModuliGiveHenckysLaw)
{
  const double bulk = E / (3 * (1 - 2 * nu)), shear = E / (2 * (1 + nu));
  const std::array<double, 3> strain{0.02, -0.05, -0.1};
  const double volume = strain[0] + strain[1] + strain[2];
  for (const double increment : {1., 1e-2, 1e-3}) {
    const auto stress = end_of(constants(), strain, increment).stress;
    for (unsigned i = 0; i < 3; ++i)
      EXPECT_NEAR(stress[i][i],
                  bulk * volume + 2 * shear * (strain[i] - volume / 3),
                  1e-9 * E);
    EXPECT_DOUBLE_EQ(stress[0][1], 0);
  }
}

TEST(Elastic, ModuliFollowDensity)
{
  // E = m D, so p = m / (3 (1 - 2 nu)) times the integral of dD / D * D.
  ElasticParameters parameters = constants();
  const double m = 1e9;
  parameters.elasticity.youngs_modulus =
      DensityTable({{0.1, 1.}, {0.1 * m, m}}, "Young's modulus");
  parameters.initial_relative_density = 0.5;
  const double density = 0.5 * std::exp(0.3);
  const double exact = m / (3 * (1 - 2 * nu)) * (density - 0.5);
  double error[2];
  unsigned i = 0;
  for (const double increment : {0.02, 0.01}) {
    const auto answer = end_of(parameters, {-0.1, -0.1, -0.1}, increment);
    EXPECT_NEAR(answer.relative_density, density, 1e-12);
    error[i++] = std::abs(-trace(answer.stress) / 3 - exact) / exact;
  }
  EXPECT_LT(error[1], 1e-4);
  EXPECT_NEAR(error[0] / error[1], 4, 0.1); // second order
}

TEST(Elastic, InitialStressIsThere)
{
  ElasticParameters parameters = constants();
  parameters.initial_stress[2][2] = -3e6;
  ContinuumPoints<Elastic> points(Elastic(parameters), 1);
  EXPECT_EQ(points.state(0).stress[2][2], -3e6);
}

TEST(Elastic, OutsideItsTablesItIsDoubtful)
{
  ElasticParameters parameters;
  parameters.elasticity = {mcc_ph102::youngs_modulus(),
                           mcc_ph102::poissons_ratio()};
  parameters.initial_relative_density = 0.97;
  EXPECT_EQ(end_of(parameters, {0, 0, -0.02}, 1e-2).status, Status::doubtful);
  parameters.initial_relative_density = 0.9;
  EXPECT_EQ(end_of(parameters, {0, 0, -0.02}, 1e-2).status, Status::converged);
}

TEST(Elastic, RefusesImpossibleConstants)
{
  ElasticParameters parameters = constants();
  parameters.elasticity.poissons_ratio = 0.5;
  EXPECT_THROW(Elastic{parameters}, std::invalid_argument);
  parameters = constants();
  parameters.elasticity.youngs_modulus = 0.;
  EXPECT_THROW(Elastic{parameters}, std::invalid_argument);
  parameters = constants();
  parameters.initial_relative_density = 1.2;
  EXPECT_THROW(Elastic{parameters}, std::invalid_argument);
}
} // namespace
} // namespace tamp::fem
