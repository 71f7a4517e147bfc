// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/polar.h>
#include <dem/random_numbers.h>
#include <dem/tangent.h>
#include <tests/coupling/sample_cells.h>

#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::coupling
{
namespace
{
constexpr double round_off = 1e-14;

dem::Matrix3 random_matrix(dem::RandomNumbers &random, double size)
{
  dem::Matrix3 matrix;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      matrix(a, b) = size * (2 * random.next() - 1);
  return matrix;
}

TEST(Polar, RotationTimesStretchIsTheGradient)
{
  dem::RandomNumbers random(7);
  for (int k = 0; k < 200; ++k) {
    const dem::Matrix3 F =
        dem::Matrix3::Identity() + random_matrix(random, 0.3);
    const PolarSplit split = polar_split(F);
    EXPECT_LT((split.rotation * split.stretch - F).norm(), 10 * round_off);
    EXPECT_LT(
        (split.rotation.transpose() * split.rotation - dem::Matrix3::Identity())
            .norm(),
        10 * round_off);
    EXPECT_EQ(split.stretch, split.stretch.transpose());
  }
}

TEST(Polar, SymmetricGradientIsItsOwnStretch)
{
  dem::Matrix3 F = dem::Matrix3::Identity();
  F(2, 2) = 0.995;
  F(0, 1) = F(1, 0) = 1e-3;
  const PolarSplit split = polar_split(F);
  EXPECT_EQ(split.stretch, F);
  EXPECT_EQ(split.rotation, dem::Matrix3(dem::Matrix3::Identity()));
}

TEST(Polar, InsideOutIsRefused)
{
  dem::Matrix3 F = dem::Matrix3::Identity();
  F(2, 2) = -0.1;
  EXPECT_THROW(polar_split(F), std::domain_error);
}

TEST(Polar, TangentMapsStrainsAsTheMatrixDoes)
{
  const dem::Tangent matrix = dem::voigt_tangent(test::sample_cell());
  const Tangent4 tangent = to_tangent(matrix);
  dem::RandomNumbers random(3);
  const dem::Matrix3 any = random_matrix(random, 1);
  const dem::Matrix3 strain = 0.5 * (any + any.transpose());
  Eigen::Matrix<double, 6, 1> components;
  components << strain(0, 0), strain(1, 1), strain(2, 2), strain(1, 2),
      strain(0, 2), strain(0, 1);
  const Eigen::Matrix<double, 6, 1> wanted = matrix * components;
  const auto stress = tangent * to_tensor(strain);
  const double scale = wanted.norm();
  EXPECT_NEAR(stress[0][0], wanted[0], round_off * scale);
  EXPECT_NEAR(stress[2][2], wanted[2], round_off * scale);
  EXPECT_NEAR(stress[1][2], wanted[3], round_off * scale);
  EXPECT_NEAR(stress[0][2], wanted[4], round_off * scale);
  EXPECT_NEAR(stress[0][1], wanted[5], round_off * scale);
}

TEST(Polar, TurnedTangentMapsTurnedStrainToTurnedStress)
{
  const Tangent4 tangent = to_tangent(dem::voigt_tangent(test::sample_cell()));
  dem::RandomNumbers random(5);
  const dem::Matrix3 Q =
      polar_split(dem::Matrix3::Identity() + random_matrix(random, 0.4))
          .rotation;
  const dem::Matrix3 any = random_matrix(random, 1);
  const dem::Matrix3 strain = 0.5 * (any + any.transpose());
  const auto direct = to_matrix(dealii::Tensor<2, 3>(
      turned(tangent, Q) * to_tensor(Q * strain * Q.transpose())));
  const dem::Matrix3 wanted =
      Q * to_matrix(dealii::Tensor<2, 3>(tangent * to_tensor(strain))) *
      Q.transpose();
  EXPECT_LT((direct - wanted).norm(), 1e-13 * wanted.norm());
}
} // namespace
} // namespace tamp::coupling
