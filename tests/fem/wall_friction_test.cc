// SPDX-License-Identifier: BSD-3-Clause
#include <fem/wall_friction.h>

#include <gtest/gtest.h>

namespace tamp::fem
{
TEST(WallFriction, SticksElasticallyBelowTheLimit)
{
  const WallForce force = wall_friction(1., -0.5, 2., 10.);
  EXPECT_EQ(force.contact, WallContact::stick);
  EXPECT_DOUBLE_EQ(force.friction, 2.);
}

TEST(WallFriction, OpposesSlipWithTheLimit)
{
  const WallForce down = wall_friction(0., -100., 2., 10.);
  EXPECT_EQ(down.contact, WallContact::slips_down);
  EXPECT_DOUBLE_EQ(down.friction, 10.);
  const WallForce up = wall_friction(0., 100., 2., 10.);
  EXPECT_EQ(up.contact, WallContact::slips_up);
  EXPECT_DOUBLE_EQ(up.friction, -10.);
}

TEST(WallFriction, FallsWithTheNormalForceWithoutSlip)
{
  EXPECT_DOUBLE_EQ(wall_friction(8., 0., 2., 5.).friction, 5.);
}

TEST(WallFriction, VanishesWhereTheWallWouldPull)
{
  const WallForce force = wall_friction(8., 1., 2., -1.);
  EXPECT_EQ(force.contact, WallContact::open);
  EXPECT_DOUBLE_EQ(force.friction, 0.);
}
} // namespace tamp::fem
