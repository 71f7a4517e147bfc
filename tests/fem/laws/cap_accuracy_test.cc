// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/drucker_prager_cap.h>
#include <tests/fem/laws/rate_integration.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <set>
#include <vector>

namespace tamp::fem
{
namespace
{
using Surface = DruckerPragerCap::Surface;
using Three = RateIntegration::Three;

/// A path in legs of logarithmic strain, compression positive.
struct Path {
  double transition;
  std::vector<Three> legs;
  Surface end; ///< the surface it ends on
  Dilation dilation = Dilation::full;
};

constexpr double die_increment = 1e-2;

struct End {
  Three stress{}; ///< compression positive [Pa]
  Surface surface = Surface::none;
};

/// The end of a path by the law, in increments as a die model takes them.
End end_of(const Path &path, const DruckerPragerCapParameters &parameters)
{
  const DruckerPragerCap law(parameters);
  auto old = law.initial_state(), now = old;
  for (const Three &leg : path.legs) {
    double largest = 0;
    for (const double strain : leg)
      largest = std::max(largest, std::abs(strain));
    const double count = std::ceil(largest / die_increment - 1e-9);
    for (double step = 0; step < count; ++step) {
      Deformation increment;
      for (unsigned i = 0; i < 3; ++i)
        increment.relative_F[i][i] = std::exp(-leg[i] / count);
      EXPECT_EQ(law.respond(old, now, increment, Want::stress).status,
                Status::converged);
      old = now;
    }
  }
  return {{-old.stress[0][0], -old.stress[1][1], -old.stress[2][2]},
          old.surface};
}

double error(const Three &stress, const Three &exact)
{
  double off = 0, size = 0;
  for (unsigned i = 0; i < 3; ++i) {
    off += std::pow(stress[i] - exact[i], 2);
    size += std::pow(exact[i], 2);
  }
  return std::sqrt(off / size);
}

/// Against the rate equations in steps of 1e-5, which halved steps change by
/// less than 1e-6.
void expect_accurate(const Path &path)
{
  DruckerPragerCapParameters parameters;
  parameters.transition = path.transition;
  parameters.dilation = path.dilation;
  RateIntegration rates(parameters);
  for (const Three &leg : path.legs)
    rates.press(leg, 1e-5);

  const End usual = end_of(path, parameters);
  parameters.integration_tolerance = 1e-5;
  const End tight = end_of(path, parameters);
  const double usual_error = error(usual.stress, rates.stress()),
               tight_error = error(tight.stress, rates.stress());
  std::cout << "relative error of stress, default tolerance: " << usual_error
            << ", 1e-5: " << tight_error << '\n';
  EXPECT_EQ(usual.surface, path.end);
  EXPECT_LT(usual_error, 1e-4); // what the documentation says
  EXPECT_LT(tight_error, 2e-5); // so does this
  // The tolerance is felt, unless both are as good as the rates.
  EXPECT_LT(tight_error, std::max(0.5 * usual_error, 5e-6));
}

TEST(CapAccuracy, DiePressing)
{
  expect_accurate({0, {{0, 0, 0.7}}, Surface::cap});
}

TEST(CapAccuracy, IsotropicPressing)
{
  expect_accurate({0, {{0.3, 0.3, 0.3}}, Surface::cap});
}

TEST(CapAccuracy, AlongTheShearLine)
{
  expect_accurate({0, {{0, 0, 0.7}, {-0.02, 0, -0.02}}, Surface::shear});
}

TEST(CapAccuracy, AlongTheShearLineWithBoundedDilation)
{
  expect_accurate(
      {0, {{0, 0, 0.7}, {-0.02, 0, -0.02}}, Surface::shear, Dilation::bounded});
}

TEST(CapAccuracy, UnloadingInTheDieToShearFailure)
{
  expect_accurate({0.02, {{0, 0, 0.5}, {0, 0, -0.06}}, Surface::shear});
}

TEST(CapAccuracy, ThroughTheTransition)
{
  // Unloaded, then sheared at constant volume: from the shear line to the arc.
  expect_accurate({0.02,
                   {{0, 0, 0.3}, {0, 0, -0.02}, {0.025, 0.025, -0.05}},
                   Surface::transition});
}

TEST(CapAccuracy, WhatIsNotResolvedIsDoubtful)
{
  DruckerPragerCapParameters parameters;
  parameters.integration_tolerance = 1e-12; // less than 2^-8 of 5e-3 can do
  const DruckerPragerCap law(parameters);
  auto old = law.initial_state(), now = old;
  Deformation increment;
  increment.relative_F =
      dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
  increment.relative_F[2][2] = 0.95;
  EXPECT_EQ(law.respond(old, now, increment, Want::stress).status,
            Status::doubtful);
}
} // namespace
} // namespace tamp::fem
