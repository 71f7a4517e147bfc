// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/rolling.h>

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
constexpr double exact = 1e-12; // round-off of closed forms

double length(const Vector &a)
{
  return std::sqrt(dot(a, a));
}

/// A contact of two grains that rolls about `across` and twists about `n`.
struct RollingPair : testing::Test {
  Rolling law{8e9, 3e9, 0.1, 0.4};
  RollingMotion<double> now{.pair = {2e-4, 5e-5, 0, 1e9},
                            .normal = {1.0 / 3, 2.0 / 3, -2.0 / 3},
                            .rotation = {0, 0, 0},
                            .spin = 0,
                            .old_radius = 1e-6,
                            .push = {2e-3, 1e-6, 0}};
  Vector across{2.0 / 3, 1.0 / 3, 2.0 / 3}, n = now.normal;
  std::array<double, Rolling::more> memory{};

  RollingAnswer<double> answer(const Vector &old)
  {
    return law(old, now, memory.data());
  }
  RollingAnswer<double> start(double roll, double twist)
  {
    now.rotation = roll * across + twist * n;
    return answer({0, 0, 0});
  }
};

TEST_F(RollingPair, SpringOpposesRolling)
{
  const double arm = 0.1 * 5e-5, k = 2.25 * 2 * 8e9 * 1e-6 * arm * arm;
  const auto found = start(1e-4, 0);
  EXPECT_LT(length(found.moment + (1e-4 * k) * across), exact * 1e-4 * k);
  EXPECT_NEAR(found.lost_work, 0, exact * 1e-8 * k);
}

TEST_F(RollingPair, RollingMomentIsCappedAndLosesCapTimesSlip)
{
  const double most = 0.1 * 5e-5 * 2e-3;
  const double k = law.rolling_stiffness(now.pair, 1e-6), turn = 3 * most / k;
  const auto found = start(turn, 0);
  EXPECT_LT(length(found.moment + most * across), exact * most);
  EXPECT_NEAR(found.lost_work, most * (turn - most / k), exact * most * turn);
}

TEST_F(RollingPair, TwistingHasStiffnessAndCapOfMarshall)
{
  const double k = 0.5 * 8 * 3e9 * 1e-18, most = 2.0 / 3 * 0.4 * 1e-6 * 2e-3;
  EXPECT_LT(length(start(0, 1e-3).moment + (1e-3 * k) * n), exact * 1e-3 * k);
  const auto found = start(0, 1);
  EXPECT_LT(length(found.moment + most * n), exact * most);
  EXPECT_NEAR(found.lost_work, most * (1 - most / k), exact * most);
}

TEST_F(RollingPair, TwistingLiesWithinExactBoundsOfCircularContact)
{
  // Equal grains: G* = G / (2 (2 - nu)); torsion of Reissner and Sagoci is
  // 16/3 a^3 G / 2, and gross slip under Hertz's pressure 3 pi/16 mu a N.
  for (const double nu : {0.0, 0.3, 0.5}) {
    const double torsion = 8.0 / 3 * 2 * (2 - nu) * 3e9 * 1e-18;
    EXPECT_LT(law.twisting_stiffness(1e-6), torsion);
  }
  const double hertz = 3 * std::numbers::pi / 16 * 0.4 * 1e-6 * 2e-3;
  EXPECT_GT(law.twisting_cap(now.push), hertz);
  EXPECT_LT(law.twisting_cap(now.push), 1.14 * hertz); // 32 / (9 pi) = 1.132
}

TEST_F(RollingPair, BothMomentsTurnWithContact)
{
  const Vector old = start(1e-4, 1e-3).moment;
  const double twist = dot(old, n), roll = length(old - twist * n);
  now.rotation = {0, 0, 0};
  // The normal goes a quarter round in small steps, towards the rolling axis,
  // where moments fixed in space would exchange their roles.
  Vector moment = old;
  const Vector from = n;
  constexpr int parts = 1000;
  for (int k = 1; k <= parts; ++k) {
    const double angle = 0.5 * std::numbers::pi * k / parts;
    now.normal = std::cos(angle) * from + std::sin(angle) * across;
    moment = answer(moment).moment;
  }
  EXPECT_NEAR(dot(moment, now.normal), twist, 1e-10 * std::abs(twist));
  EXPECT_NEAR(length(moment - twist * now.normal), roll, 1e-10 * roll);
  EXPECT_NEAR(dot(moment, from), roll, 1e-10 * roll); // -across to +from
}

TEST_F(RollingPair, RollingMomentTurnsWithSpinOfGrains)
{
  const Vector old = start(1e-4, 0).moment;
  now.rotation = {0, 0, 0};
  now.spin = 1e-3;
  const Vector wanted = old + 1e-3 * cross(n, old);
  EXPECT_LT(length(answer(old).moment - wanted), exact * length(old));
}

TEST_F(RollingPair, NoMomentWithoutNormalForceOrFriction)
{
  now.push.force = 0;
  EXPECT_EQ(length(start(1e-3, 1e-3).moment), 0);
  now.push.force = 2e-3;
  law.rolling_friction = law.friction_coefficient = 0;
  EXPECT_EQ(length(start(1e-3, 1e-3).moment), 0);
}

TEST_F(RollingPair, OpeningLosesAllThatIsStored)
{
  const Vector old = start(1e-4, 1e-3).moment;
  const double held = law.stored(old, n, now.pair, 1e-6);
  const double roll = law.rolling_stiffness(now.pair, 1e-6);
  const double twist = law.twisting_stiffness(1e-6);
  EXPECT_NEAR(held, 0.5 * (roll * 1e-8 + twist * 1e-6), exact * held);
  now.rotation = {0, 0, 0};
  now.push = {0, 0, 0};
  EXPECT_NEAR(answer(old).lost_work, held, exact * held);
  EXPECT_EQ(length(answer(old).moment), 0);
}

TEST_F(RollingPair, AFallingLimitOrRadiusLosesTheDifferenceOfWhatIsStored)
{
  for (const double radius : {1e-6, 0.8e-6, 1.3e-6}) {
    now.push = {2e-3, 1e-6, 0};
    now.old_radius = 1e-6;
    memory = {};
    const Vector old = start(1, 1).moment; // at both limits
    const double held = law.stored(old, n, now.pair, 1e-6);
    now.rotation = {0, 0, 0};
    now.push = {0.3 * 2e-3, radius, 0};
    const auto found = answer(old);
    const double left = law.stored(found.moment, n, now.pair, radius);
    EXPECT_LT(left, 0.5 * held);
    EXPECT_NEAR(found.lost_work, held - left, exact * held);
  }
}

TEST_F(RollingPair, ANewContactLosesNothingInSinglePrecision)
{
  const Rolling stiff{8e10f, 3e10f, 0.1f, 0.4f};
  const RollingMotion<float> first{.pair = {2, 0.5, 0, 1},
                                   .normal = {1, 0, 0},
                                   .rotation = {0, 0, 0},
                                   .spin = 0,
                                   .old_radius = 0,
                                   .push = {2e3f, 1e-2f, 0}};
  std::array<float, Rolling::more> none{};
  EXPECT_EQ(stiff({0, 0, 0}, first, none.data()).lost_work, 0);
}

TEST_F(RollingPair, RandomPathsStayBelowLimitsAndOnlyHeat)
{
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> one(-1, 1);
  Vector moment{0, 0, 0};
  double radius = 1e-6;
  for (int k = 0; k < 100000; ++k) {
    now.old_radius = radius;
    radius = 1e-6 * (1.01 + one(random));
    now.push = {2e-3 * std::pow(radius / 1e-6, 3), radius, 0};
    now.rotation = (1e-3 * one(random)) * across + (0.3 * one(random)) * n +
                   (1e-3 * one(random)) * cross(n, across);
    const auto found = answer(moment);
    const double twist = std::abs(dot(found.moment, n));
    const double roll = length(found.moment - dot(found.moment, n) * n);
    const double round_off =
        exact * (length(found.moment) + twist + roll + length(moment));
    ASSERT_LE(twist, law.twisting_cap(now.push) + round_off);
    ASSERT_LE(roll, law.rolling_cap(now.pair, now.push) + round_off);
    ASSERT_GE(found.lost_work, -1e-25); // round-off of 1e-13 J
    moment = found.moment;
  }
}
} // namespace
} // namespace tamp::dem
