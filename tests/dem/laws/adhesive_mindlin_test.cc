// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/adhesive_mindlin.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace tamp::dem
{
namespace
{
using Vector = Triple<double>;

double length(const Vector &a)
{
  return std::sqrt(dot(a, a));
}

/// Two spheres that adhere as Johnson, Kendall and Roberts have it.
struct StickyPair : testing::Test {
  double modulus = 8e9, shear = 3e9, radius = 5e-5, adhesion = 0.2;
  double pull_off = 1.5 * std::numbers::pi * adhesion * radius;
  AdhesiveMindlin law{modulus, shear, 0.4};
  ContactMotion<double> now{};
  Vector along{2.0 / 3, 1.0 / 3, 2.0 / 3};

  void press(double force)
  {
    now.normal = {1.0 / 3, 2.0 / 3, -2.0 / 3};
    const double one =
        force + 2 * pull_off +
        2 * std::sqrt(std::max(0.0, pull_off * (force + pull_off)));
    now.push = {force, std::cbrt(0.75 * radius / modulus * one), pull_off};
    now.old_radius = now.push.contact_radius;
  }
  double peeling_end() const
  {
    return 4 *
           std::sqrt(pull_off * (now.push.force + pull_off) * shear / modulus);
  }
  double slip_once(double slip)
  {
    now.slip = slip * along;
    return dot(law({0, 0, 0}, now, static_cast<double *>(nullptr)).force,
               along);
  }
};

TEST_F(StickyPair, PeelingReleasesWorkOfAdhesion)
{
  // (N_1 - N)^2 / (6 pi R* N_1) + T^2 E* / (24 pi G* R* N_1) = Gamma with
  // N_1 = 4 E* a^3 / (3 R*).
  for (const double force : {-0.5, 0.0, 3.0, 50.0}) {
    press(force * pull_off);
    for (const double share : {0.0, 0.3, 0.9, 1.0}) {
      const double t = share * peeling_end();
      const double a = law.peeled_radius(now.push, t * t);
      const double one = 4 * modulus * a * a * a / (3 * radius);
      const double apart = one - now.push.force;
      const double released = (apart * apart + t * t * modulus / (4 * shear)) /
                              (6 * std::numbers::pi * radius * one);
      EXPECT_NEAR(released, adhesion, 1e-7 * adhesion); // root at the end
    }
  }
}

TEST_F(StickyPair, PeelingEndsAtHertzianPartOfRadius)
{
  press(2 * pull_off);
  const double end = peeling_end();
  const double least = std::cbrt(0.75 * radius / modulus * 4 * pull_off);
  for (const double t : {end, 1.5 * end})
    EXPECT_NEAR(law.peeled_radius(now.push, t * t), least, 1e-8 * least);
  EXPECT_GT(law.peeled_radius(now.push, 0.99 * end * end), 1.01 * least);
}

TEST_F(StickyPair, SmallForceHasStiffnessOfMindlin)
{
  press(2 * pull_off);
  const double k = 8 * shear * now.push.contact_radius, slip = 1e-14;
  EXPECT_NEAR(slip_once(slip), k * slip, 1e-6 * k * slip);
}

TEST_F(StickyPair, OneIncrementEqualsThousand)
{
  press(2 * pull_off);
  law.friction_coefficient = 10; // no cap in the way
  const double slip =
      0.9 * peeling_end() / (8 * shear * now.push.contact_radius);
  const double once = slip_once(slip);
  Vector often{0, 0, 0};
  now.slip = (1e-3 * slip) * along;
  for (int k = 0; k < 1000; ++k)
    often = law(often, now, static_cast<double *>(nullptr)).force;
  EXPECT_NEAR(once, dot(often, along), 2e-3 * once); // Simpson, near the end
  EXPECT_LT(once, 8 * shear * now.push.contact_radius * slip);
}

TEST_F(StickyPair, SlidesAtFrictionTimesForceAndTwicePullOff)
{
  for (const double force : {-1.0, 0.0, 2.0, 1000.0}) {
    press(force * pull_off);
    const double most = 0.4 * (now.push.force + 2 * pull_off);
    EXPECT_NEAR(slip_once(1e-6), most, 1e-12 * most);
  }
}

TEST_F(StickyPair, IsMindlinWithoutAdhesion)
{
  pull_off = 0;
  press(2e-4);
  const Mindlin mindlin{shear, 0.4};
  double *const none = nullptr;
  const double k = 8 * shear * now.push.contact_radius;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> one(-1, 1);
  Vector old{0, 0, 0};
  for (int i = 0; i < 200; ++i) {
    press(2e-4 * (0.6 + 0.4 * one(random))); // the cap rises and falls
    if (i % 20 == 19)
      now.push = {0, 0, 0}; // and the contact opens
    now.old_radius = 1e-6 * (1 + 0.3 * one(random));
    now.slip = {1e-4 / k * one(random), 1e-4 / k * one(random), 0};
    const auto a = mindlin(old, now, none), b = law(old, now, none);
    EXPECT_LT(length(a.force - b.force), 1e-12 * 8e-5); // round-off
    // Mindlin's leaves out limits that fall by less than a thousandth.
    EXPECT_NEAR(a.lost_work, b.lost_work, 1e-6 * 1e-8 / k);
    old = a.force;
  }
}

TEST_F(StickyPair, ClosedSlipPathsReturnTheirWork)
{
  // Below the cap a force that peels is a function of the slip on a line, and
  // nearly so around a triangle.
  press(2 * pull_off);
  law.friction_coefficient = 10;
  const double size =
      0.5 * peeling_end() / (8 * shear * now.push.contact_radius);
  const Vector aside = cross(now.normal, along);
  const std::array<Vector, 3> legs = {
      size * along, size * aside, (-size) * (along + aside)};
  Vector force{0, 0, 0};
  double work = 0, moved = 0;
  constexpr int parts = 1000;
  for (const Vector &leg : legs)
    for (int k = 0; k < parts; ++k) {
      now.slip = (1.0 / parts) * leg;
      const Vector next = law(force, now, static_cast<double *>(nullptr)).force;
      const double part = 0.5 * dot(force + next, now.slip);
      force = next, work += part, moved += std::abs(part);
    }
  // What is left in the force is what the work has paid for.
  EXPECT_GE(work, -1e-5 * moved); // trapezoids
  EXPECT_LT(length(force), 0.05 * peeling_end());
}

TEST(CubeRoot, IsExactToFourteenDigitsAndZeroAtZero)
{
  EXPECT_EQ(cube_root(0.0), 0);
  for (int k = 0; k <= 3000; ++k) {
    const double x = std::pow(10, -0.01 * k), y = std::cbrt(x);
    EXPECT_NEAR(cube_root(x), y, 1e-14 * y + 1e-18);
    EXPECT_NEAR(cube_root(static_cast<float>(x)), y, 3e-7 * y + 1e-12);
  }
}
} // namespace
} // namespace tamp::dem
