// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/mindlin.h>
#include <dem/tensors.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

namespace tamp::dem
{
namespace
{
double *const no_more = nullptr;

Triple<double> triple(const Vector3 &v)
{
  return {v[0], v[1], v[2]};
}

/// A sticking contact with mu = 0.4.
struct RubbingPair : testing::Test {
  Mindlin law{3e9, 0.4};
  double normal_force = 2e-3, radius = 1e-6, old_radius = 1e-6, spin = 0;
  Vector3 normal = Vector3(1, 2, -2) / 3, slip = Vector3::Zero();
  Vector3 along = Vector3(2, 1, 2) / 3; // in the plane of the contact
  double stiffness = 8 * law.effective_shear_modulus * radius;
  double cap = law.friction_coefficient * normal_force;

  struct Answer {
    Vector3 force;
    double lost_work;
  };
  Answer rub(const Vector3 &old_force) const
  {
    const ContactMotion<double> now = {.pair = {2e-4, 5e-5, 0, 0},
                                       .normal = triple(normal),
                                       .slip = triple(slip),
                                       .spin = spin,
                                       .old_radius = old_radius,
                                       .push = {normal_force, radius, 0}};
    const auto [force, lost] = law(triple(old_force), now, no_more);
    return {{force.x, force.y, force.z}, lost};
  }
  /// T^2 / (2 k_t) of a force at a contact radius.
  double energy(const Vector3 &force, double at) const
  {
    return force.squaredNorm() / (2 * law.stiffness(at));
  }
};

TEST_F(RubbingPair, SticksWithStiffnessOfMindlin)
{
  slip = 1e-9 * along + 3e-9 * normal; // approach is no slip
  const Answer answer = rub(Vector3::Zero());
  const double size = stiffness * 1e-9;
  EXPECT_LT((answer.force - size * along).norm(), 1e-12 * size);
  EXPECT_EQ(answer.lost_work, 0);
  EXPECT_EQ(law.stiffness(radius), stiffness);
}

TEST_F(RubbingPair, NewContactSticksLikeAnOldOne)
{
  slip = 1e-9 * along;
  const Vector3 wanted = rub(Vector3::Zero()).force;
  old_radius = 0;
  EXPECT_EQ(rub(Vector3::Zero()).force, wanted);
  EXPECT_EQ(rub(Vector3::Zero()).lost_work, 0);
}

TEST_F(RubbingPair, CoulombsCapKeepsDirection)
{
  slip = 1e-7 * along;
  const Answer answer = rub(Vector3::Zero());
  EXPECT_LT((answer.force - cap * along).norm(), 1e-12 * cap);
}

TEST_F(RubbingPair, LostWorkOfSlidingIsCapTimesSlidDistance)
{
  slip = 1e-7 * along;
  const double excess = stiffness * 1e-7 - cap;
  const double work = cap * excess / stiffness;
  EXPECT_NEAR(rub(Vector3::Zero()).lost_work, work, 1e-12 * work);
}

TEST_F(RubbingPair, SteadySlidingDissipatesCapTimesSlip)
{
  const double step = 1e-9;
  slip = step * along;
  // Round-off of T^2 against cap times slip: 1e-9.
  EXPECT_NEAR(rub(cap * along).lost_work, cap * step, 1e-9 * cap * step);
}

TEST_F(RubbingPair, ForceTurnsWithContactAndKeepsLength)
{
  const Vector3 old = 1e-4 * along;
  normal = (normal + 0.1 * along).normalized();
  const Answer answer = rub(old);
  EXPECT_NEAR(answer.force.norm(), old.norm(), 1e-12 * old.norm());
  EXPECT_NEAR(answer.force.dot(normal), 0, 1e-12 * old.norm());
  EXPECT_GT(answer.force.dot(old), 0.99 * old.squaredNorm());
  EXPECT_NEAR(answer.lost_work, 0, 1e-12 * energy(old, radius));
}

TEST_F(RubbingPair, ForceTurnsWithSpinOfGrains)
{
  const Vector3 old = 1e-4 * along;
  spin = 1e-3;
  const Vector3 wanted = old + spin * normal.cross(old);
  EXPECT_LT((rub(old).force - wanted).norm(), 1e-12 * old.norm());
}

TEST_F(RubbingPair, ForceShrinksWithContactRadiusOnUnloadingOnly)
{
  const Vector3 old = 1e-4 * along;
  radius = 0.5 * old_radius;
  EXPECT_LT((rub(old).force - 0.5 * old).norm(), 1e-12 * old.norm());
  radius = 2 * old_radius;
  EXPECT_LT((rub(old).force - old).norm(), 1e-12 * old.norm());
}

TEST_F(RubbingPair, LostWorkIsEnergyThatAChangeOfRadiusTakes)
{
  const Vector3 old = 1e-4 * along;
  for (double share : {0.5, 0.9, 1.1, 2.0}) {
    radius = share * old_radius;
    const double before = energy(old, old_radius);
    const Answer answer = rub(old);
    const double lost = before - energy(answer.force, radius);
    EXPECT_GT(lost, 0.05 * before); // there is something to compare
    EXPECT_NEAR(answer.lost_work, lost, 1e-12 * before);
  }
}

TEST_F(RubbingPair, SlidingAndShrinkingLoseWorkOfSlipLessEnergyGained)
{
  // Along one line, shrunk first and then pushed to the cap and beyond.
  radius = 0.5 * old_radius;
  const Vector3 old = 2e-4 * along;
  slip = 1e-7 * along;
  const double k = law.stiffness(radius), kept = 1e-4;
  const double stuck = (cap - kept) / k; // slip before the cap is reached
  const double work = 0.5 * (kept + cap) * stuck + cap * (1e-7 - stuck);
  const Answer answer = rub(old);
  const double gained = energy(answer.force, radius) - energy(old, old_radius);
  ASSERT_GT(1e-7, stuck);
  EXPECT_NEAR(answer.lost_work, work - gained, 1e-12 * work);
}

TEST_F(RubbingPair, NoForceWithoutNormalForce)
{
  normal_force = 0;
  slip = 1e-9 * along;
  const Vector3 old = 1e-4 * along;
  const double stored = energy(old, old_radius);
  EXPECT_EQ(rub(old).force.norm(), 0);
  // Nothing resists the slip, and nothing is left of what was stored.
  EXPECT_NEAR(rub(old).lost_work, stored, 1e-12 * stored);
  EXPECT_EQ(law.cap(NormalAnswer<double>{-1e-3, radius, 0}), 0);
}

TEST_F(RubbingPair, FallingCapTakesItsShareOfTheEnergy)
{
  const Vector3 old = 0.9 * cap * along;
  const double stored = energy(old, old_radius);
  for (double share : {0.8, 0.5, 0.0}) {
    normal_force = share * 2e-3; // no slip at all
    const Answer answer = rub(old);
    const double lost = stored - energy(answer.force, radius);
    EXPECT_GT(lost, 0.1 * stored); // there is something to compare
    EXPECT_NEAR(answer.lost_work, lost, 1e-12 * stored);
  }
}

TEST_F(RubbingPair, OpeningContactLosesAllThatIsStored)
{
  normal_force = radius = 0;
  slip = 1e-9 * along;
  const Vector3 old = 1e-4 * along;
  const double stored = energy(old, old_radius);
  EXPECT_EQ(rub(old).force.norm(), 0);
  EXPECT_NEAR(rub(old).lost_work, stored, 1e-12 * stored);
}

TEST(NoTangentialForce, IsNone)
{
  const NoTangentialForce law;
  const ContactMotion<double> now = {.pair = {2e-4, 5e-5, 0, 0},
                                     .normal = {1, 0, 0},
                                     .slip = {0, 1e-9, 0},
                                     .spin = 0,
                                     .old_radius = 1e-6,
                                     .push = {2e-3, 1e-6, 0}};
  const auto [force, lost] = law(Triple<double>{0, 1, 0}, now, no_more);
  EXPECT_EQ(dot(force, force), 0);
  EXPECT_EQ(lost, 0);
  EXPECT_EQ(law.stiffness(1e-6), 0);
}
} // namespace
} // namespace tamp::dem
