// SPDX-License-Identifier: BSD-3-Clause
#include <tests/dem/pair_throw.h>

#include <array>
#include <gtest/gtest.h>

namespace tamp::dem::test
{
namespace
{
TEST(Impact, BooksEveryLossOfEnergy)
{
  constexpr double tolerance = 1e-3; // of the energy before, 4000 steps
  struct Row {
    NormalLaw normal;
    TangentialLaw tangential;
    double restitution;
    RollingLaw rolling = RollingLaw::none;
  };
  using enum NormalLaw;
  constexpr auto smooth = TangentialLaw::none, mindlin = TangentialLaw::mindlin,
                 slips = TangentialLaw::mindlin_deresiewicz;
  const GrainMaterial solid{70e9, .3, 2650, 0.5e9};
  for (const Row &row :
       std::array<Row, 12>{{{hertz, smooth, 1},
                            {hertz, mindlin, 1},
                            {hertz, slips, 1},
                            {hertz, mindlin, .3},
                            {hertz, mindlin, .8, RollingLaw::epsd},
                            {thornton_ning, mindlin, 1},
                            {thornton_ning, slips, 1},
                            {thornton_ning, mindlin, .7},
                            {jkr, mindlin, 1},
                            {jkr, smooth, .6},
                            {thornton_ning_jkr, mindlin, 1},
                            {storakers, mindlin, 1, RollingLaw::epsd}}})
    for (const Against against : {Against::rigid_wall, Against::equal_grain})
      for (const double sideways : {0., .3, 1.5}) {
        ContactModel model = hertz_mindlin(row.restitution, .3);
        model.normal_law = row.normal;
        model.tangential_law = row.tangential;
        model.rolling_law = row.rolling;
        model.work_of_adhesion = 0.2;
        constexpr double radius = 2e-6, speed = 3;
        const Thrown found = thrown({solid,
                                     radius,
                                     model,
                                     speed,
                                     sideways * speed,
                                     0.5 * sideways * speed / radius,
                                     against});
        EXPECT_EQ(found.end, Rebound::End::parted);
        EXPECT_NEAR((found.kinetic_after + found.losses.total()) /
                        found.kinetic_before,
                    1,
                    tolerance)
            << int(row.normal) << int(row.tangential) << " e "
            << row.restitution << " sideways " << sideways << " plastic "
            << found.losses.plastic / found.kinetic_before << " friction "
            << found.losses.friction / found.kinetic_before << " damping "
            << found.losses.damping / found.kinetic_before << " adhesion "
            << found.losses.adhesion / found.kinetic_before;
        EXPECT_GE(found.losses.friction, 0);
        EXPECT_GE(found.losses.plastic, 0);
      }
}

TEST(Impact, KeepsMomentumAndAngularMomentumOfTwoGrains)
{
  const GrainMaterial solid{208e9, .3, 7850};
  Pair pair = pair_of(
      {solid, 1e-3, hertz_mindlin(.8, .3), 2, 1.5, 900, Against::large_grain});
  Impact impact(pair.contact, pair.bodies);
  struct Momenta {
    Triple<double> linear{0, 0, 0}, angular{0, 0, 0};
  };
  const auto momenta = [&] {
    Momenta sum;
    for (const Body &b : impact.bodies()) {
      sum.linear = sum.linear + b.mass * b.velocity;
      sum.angular = sum.angular + b.mass * cross(b.place, b.velocity) +
                    (0.4 * b.mass * b.radius * b.radius) * b.spin;
    }
    return sum;
  };
  const Momenta before = momenta();
  while (impact.step()) {
  }
  const Momenta after = momenta();
  const Triple<double> linear = after.linear - before.linear;
  const Triple<double> angular = after.angular - before.angular;
  constexpr double round_off = 1e-11; // of some thousand steps
  EXPECT_LT(sqrt(dot(linear, linear)),
            round_off * sqrt(dot(before.linear, before.linear)));
  EXPECT_LT(sqrt(dot(angular, angular)),
            round_off * sqrt(dot(before.angular, before.angular)));
}
} // namespace
} // namespace tamp::dem::test
