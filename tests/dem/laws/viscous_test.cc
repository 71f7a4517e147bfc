// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/viscous.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
/// By Antypov & Elliott; Impact.ConvergesToRestitutionOfDamping finds the same
/// by integration.
TEST(Viscous, DampingAgreesWithTable)
{
  for (const auto &[e, beta] : std::array<std::array<double, 2>, 4>{
           {{.2, .66753}, {.5, .23303}, {.8, .06788}, {.98, .00589}}})
    EXPECT_NEAR(Viscous::damping_ratio(e), beta, 5.1e-6); // digits
  EXPECT_NEAR(Viscous::damping_ratio(1), 0, 1e-15);       // bisection
}

TEST(Viscous, RefusesWhatIsNoRestitution)
{
  for (const double e : {-0.1, 0.0, 1.0001, std::nan("")})
    EXPECT_THROW(Viscous(1e9, e), std::invalid_argument);
  EXPECT_THROW(Viscous(-1, 0.5), std::invalid_argument);
}

TEST(Viscous, NeverPulls)
{
  const Viscous law(1e9, 0.3);
  ViscousMotion<double> now{};
  now.pair = {2, 1, 0, 1};
  now.normal = {1, 0, 0};
  now.push = {1e-3, 1e-6, 0};
  now.velocity = {1e3, 0, 0};        // parting fast
  EXPECT_EQ(law(now).force.x, 1e-3); // takes all of the push, no more
  now.push.pull_off = 2e-3;
  EXPECT_EQ(law(now).force.x, 3e-3); // adhesion holds as much as it can
  now.push.contact_radius = 0;
  EXPECT_EQ(law(now).force.x, 0);
}

TEST(Viscous, SpringAndDashpotStayBelowCapTogether)
{
  const Viscous law(1e9, 0.3);
  ViscousMotion<double> now{};
  now.pair = {2, 1, 0, 1};
  now.normal = {1, 0, 0};
  now.push = {1e-3, 1e-6, 0};
  now.cap = 4e-4, now.stiffness = 1e3;
  now.force = {0, 1e-4, 0};
  now.velocity = {0, 1e-7, 0};
  const auto slow = law(now);
  const double rate = 2 * law.damping() * std::sqrt(1e3);
  EXPECT_NEAR(slow.force.y, rate * 1e-7, 1e-12 * rate); // closed form
  EXPECT_EQ(slow.kept.y, 1e-4);
  now.velocity = {0, 1, 0};
  const auto fast = law(now);
  EXPECT_NEAR(now.force.y + fast.force.y, now.cap, 1e-12 * now.cap);
  EXPECT_NEAR(fast.kept.y, now.cap, 1e-12 * now.cap); // slides
}

} // namespace
} // namespace tamp::dem
