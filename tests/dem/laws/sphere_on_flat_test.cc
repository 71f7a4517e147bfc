// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/sphere_on_flat.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
constexpr double pi = std::numbers::pi;

// The grain of Zunker & Kamrin's examples, and a hard one.
const SphereOnFlat soft(1e9, 0.3, 50e6);
const SphereOnFlat hard(70e9, 0.3, 100e6);

TEST(Exponential, IsExactInItsRange)
{
  constexpr double tolerance = 1e-13; // what it promises
  for (int i = 0; i <= 1000; ++i) {
    const double x = -4.4 * i / 1000;
    EXPECT_NEAR(negative_exponential(x) / std::exp(x), 1, tolerance) << x;
  }
}

TEST(SphereOnFlat, MeetsReferenceValues)
{
  constexpr double tolerance = 1e-3; // digits of the reference, V14
  const SphereOnFlat &flat = soft;
  const double R = 0.5, Y = 50e6;
  EXPECT_NEAR(flat.yield_ratio() / 0.06239, 1, tolerance);
  EXPECT_NEAR(
      flat.flow_pressure(flat.yield_ratio()) / Y / 2.3299, 1, tolerance);
  const double cases[3][4] = {{.07, .5502, .2768, .3683},
                              {.10, .8787, .3626, .5099},
                              {.20, 1.6347, .5491, .7661}};
  for (const auto &[ratio, force, radius, plastic] : cases) {
    SCOPED_TRACE(ratio);
    const FlatPeak<double> peak = flat.peak(ratio * R, R);
    const auto push = flat.push(ratio * R, peak, R);
    EXPECT_NEAR(push.force / (R * R * Y) / force, 1, tolerance);
    EXPECT_NEAR(push.contact_radius / R / radius, 1, tolerance);
    EXPECT_NEAR(1 - peak.recovery / peak.overlap, plastic, tolerance * plastic);
    const double zero = peak.overlap - peak.recovery;
    EXPECT_EQ(flat.push(zero * (1 - 1e-9), peak, R).force, 0);
    EXPECT_GT(flat.push(zero * (1 + 1e-9), peak, R).force, 0);
  }
}

TEST(SphereOnFlat, RecoversWhatTheSourcesDisplacementCorrectionSays)
{
  constexpr double tolerance = 1e-12; // algebra
  const double E = 1e9, nu = 0.3, G = E / (2 * (1 + nu)), R = 0.5;
  const SphereOnFlat &flat = soft;
  for (double ratio : {.0625, .1, .3, .6, .9}) {
    const FlatPeak<double> peak = flat.peak(ratio * R, R);
    const double p = flat.flow_pressure(ratio), a = peak.radius;
    const double A = 4 * p * a / flat.modulus();
    const double z = R - peak.overlap + A / 2, hypotenuse = std::hypot(a, z);
    const double correction =
        pi * p * a * a *
        (2 * a * a * (nu - 1) - (2 * nu - 1) * z * (hypotenuse - z)) /
        (2 * pi * a * a * G * hypotenuse);
    EXPECT_NEAR(peak.recovery / (A / 2 + correction), 1, tolerance) << ratio;
  }
}

TEST(SphereOnFlat, UnloadsAsMesarovicAndJohnson)
{
  constexpr double tolerance = 1e-10; // of the force at the peak; rounding
  for (const SphereOnFlat *law : {&soft, &hard}) {
    const double R = 1e-4;
    const FlatPeak<double> peak = law->peak(0.15 * R, R);
    const double mean = peak.force / (pi * peak.radius * peak.radius);
    const double whole = 2 * mean * peak.radius / law->modulus();
    const double share = peak.recovery / whole; // finite height of the sphere
    for (double x : {1e-3, .1, .4, .7, .95, 1.0}) {
      const double back = share * whole * std::sqrt(1 - x * x);
      const double force =
          peak.force * 2 / pi * (std::asin(x) - x * std::sqrt(1 - x * x));
      const auto push = law->push(peak.overlap - back, peak, R);
      EXPECT_NEAR(push.force / peak.force, force / peak.force, tolerance);
      EXPECT_NEAR(push.contact_radius / peak.radius, x, 1e-6);
    }
  }
}

TEST(SphereOnFlat, HardShallowContactsRecoverAsOnAHalfSpace)
{
  const double R = 1e-4;
  const FlatPeak<double> peak = hard.peak(1e-4 * R, R);
  const double mean = peak.force / (pi * peak.radius * peak.radius);
  const double whole = 2 * mean * peak.radius / hard.modulus();
  const double tolerance = peak.radius / R; // of first order in a / R
  EXPECT_NEAR(peak.recovery / whole, 1, tolerance);
}

TEST(SphereOnFlat, ElasticBranchIsWithinHalfAPercentOfThePublishedOne)
{
  const double R = 1;
  for (double share : {.01, .1, .5, 1.0}) {
    const double u = share * soft.yield_ratio() / 4; // delta / A, A = 4 R
    const double ellipse =
        0.25 * soft.modulus() * 8 *
        (std::acos(1 - 2 * u) - (2 - 4 * u) * std::sqrt(u - u * u));
    const FlatPeak<double> peak = soft.peak(4 * u, R);
    const double hertz = soft.push(4 * u, peak, R).force;
    EXPECT_LE(ellipse, hertz * (1 + 1e-9));
    EXPECT_NEAR(ellipse / hertz, 1, 5e-3);
  }
}

TEST(SphereOnFlat, RefusesWhatNeverYields)
{
  EXPECT_THROW(SphereOnFlat(1e9, .3, 1e9), std::invalid_argument);
  EXPECT_THROW(SphereOnFlat(1e9, .5, 1e6), std::invalid_argument);
  EXPECT_THROW(SphereOnFlat(-1e9, .3, 1e6), std::invalid_argument);
  EXPECT_THROW(SphereOnFlat(1e9, .3, 0), std::invalid_argument);
}
} // namespace
} // namespace tamp::dem
