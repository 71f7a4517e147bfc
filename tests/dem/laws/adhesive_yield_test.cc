// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/adhesive_thornton_ning.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tamp::dem
{
namespace
{
using Law = AdhesiveThorntonNing;

/// p_a = (2 E*^2 Gamma / (pi^2 R*))^(1/3) [Pa].
double adhesive_pressure(double modulus, double adhesion, double radius)
{
  return std::cbrt(2 * modulus * modulus * adhesion /
                   (std::numbers::pi * std::numbers::pi * radius));
}

/// The least that a path from no contact to no contact loses, over all largest
/// overlaps, over what an elastic contact loses [-].
/// @param hardness  p_y / p_a, the only number of the law in JKR's units
double least_loss(double hardness)
{
  constexpr double adhesion = 1e-3, depth = 0.016; // a tear-off's, about
  const PairShape<double> pair = {4, 1, 0, 1};
  const Law law(1, hardness * adhesive_pressure(1, adhesion, 1), adhesion);
  const double first = law.lost_at_touch(pair, {0, 0});
  double least = std::numeric_limits<double>::infinity();
  for (double share = 1e-3; share < 1e4; share *= 1.01) {
    const NormalMemory<double> memory = {share * depth, 0};
    EXPECT_GT(law.lost_at_touch(pair, memory), 0);
    EXPECT_GT(law.lost_at_tear(pair, memory), 0);
    least = std::min(least,
                     first + law.energy(0, pair, memory).dissipated +
                         law.lost_at_tear(pair, memory));
  }
  const Jkr jkr(1, adhesion);
  return least /
         (jkr.lost_at_touch(pair, {0, 0}) + jkr.lost_at_tear(pair, {0, 0}));
}

TEST(AdhesiveYield, ClosedPathsLoseDownToTheLeastPressureAndNoFurther)
{
  for (const double hardness : {0.425, 0.5, 0.7, 1.0, 1.5, 5.0})
    EXPECT_GT(least_loss(hardness), 0) << hardness;
  EXPECT_LT(least_loss(0.425), 0.01); // the bound is sharp
  EXPECT_LT(least_loss(0.4245), 0);
}

TEST(AdhesiveYield, RefusesAPressureThatWouldGainEnergy)
{
  const double radius = 1e-5;
  const double least = AdhesiveYield::least_pressure(4e10, 0.1, radius);
  EXPECT_DOUBLE_EQ(least, 0.425 * adhesive_pressure(4e10, 0.1, radius));
  EXPECT_NO_THROW(Law(4e10, (1 + 1e-12) * least, 0.1).check(radius));
  EXPECT_NO_THROW(Law(4e10, 1, 0).check(radius));
  try {
    Law(4e10, 0.999 * least, 0.1).check(radius);
    FAIL();
  } catch (const std::invalid_argument &error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("limiting contact pressure = "), message.npos);
    EXPECT_NE(message.find("work of adhesion of 0.1 J/m2"), message.npos);
    EXPECT_NE(message.find("reduced radius of 1e-05 m"), message.npos);
  }
}
} // namespace
} // namespace tamp::dem
