// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/agcusnin.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace tamp::fem
{
namespace
{
TEST(AgCuSnIn, RowsAreThoseOfTheSource)
{
  const auto parameters = agcusnin::parameters();
  EXPECT_NO_THROW(parameters.check());
  // Plastic volumetric strain and p_b [MPa].
  constexpr std::array<std::array<double, 2>, 9> rows{{{0, 0.433},
                                                       {0.351, 19.4},
                                                       {0.420, 27.6},
                                                       {0.471, 37.8},
                                                       {0.555, 59.2},
                                                       {0.616, 77.6},
                                                       {0.682, 101},
                                                       {0.771, 147},
                                                       {0.795, 216}}};
  for (const auto &[strain, pressure] : rows)
    EXPECT_NEAR(
        parameters.hardening.read(strain).value, pressure * 1e6, 1e-6) // Pa
        << strain;
  EXPECT_EQ(parameters.initial_relative_density, 0.42);
  EXPECT_EQ(parameters.transition, 0.02);
  const auto moduli = parameters.elasticity.at(0.9);
  EXPECT_NEAR(9 * moduli.bulk * moduli.shear / (3 * moduli.bulk + moduli.shear),
              49.2e9,
              1); // round-off
}

TEST(AgCuSnIn, CohesionIsTheExponentialOfTheSource)
{
  const auto cohesion = agcusnin::parameters().cohesion;
  for (double density = 0.42; density < 0.9; density += 0.003) {
    const double exact = 24180.7 * std::exp(13.07 * (density - 0.42));
    const double read = cohesion.read(density).value;
    EXPECT_GE(read, exact * (1 - 1e-12)); // a line is above what is convex
    EXPECT_LT(read, exact * 1.009);       // (13.07 * 0.02)^2 / 8
  }
}

TEST(AgCuSnIn, CanBePressedInADie)
{
  // To D = 0.85; axial stress rises to more than p_b of the start by far.
  const DruckerPragerCap law(agcusnin::parameters());
  auto old = law.initial_state(), now = old;
  Deformation increment;
  for (unsigned i = 0; i < 3; ++i)
    increment.relative_F[i][i] = i == 2 ? std::exp(-5e-3) : 1;
  while (old.relative_density < 0.85) {
    const auto answer = law.respond(old, now, increment, Want::stress);
    ASSERT_EQ(answer.status, Status::converged) << old.relative_density;
    ASSERT_LT(now.stress[2][2], old.stress[2][2]);
    ASSERT_LT(law.yield(now), 1e-9); // the return stops at 1e-10
    old = now;
  }
  EXPECT_EQ(old.surface, DruckerPragerCap::Surface::cap);
  EXPECT_GT(-old.stress[2][2], 50e6);
}
} // namespace
} // namespace tamp::fem
