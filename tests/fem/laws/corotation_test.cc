// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/corotation.h>

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace tamp::fem
{
namespace
{
using dealii::SymmetricTensor;
using dealii::Tensor;

const Tensor<2, 3> one(dealii::unit_symmetric_tensor<3>());

/// In general, in one plane, with equal stretches, and small.
std::vector<Tensor<2, 3>> increments()
{
  Tensor<2, 3> general = 1.1 * one, plane = one, equal = 0.7 * one, small = one;
  general[0][1] = 0.3;
  general[1][2] = -0.2;
  general[2][0] = 0.15;
  plane[0][0] = 0.8;
  plane[0][2] = 0.25;
  plane[2][0] = -0.1;
  equal[2][2] = 1.3;
  small[0][1] = 2e-5;
  small[2][2] -= 1e-4;
  small[1][2] = 3e-6;
  return {general, plane, equal, small, one};
}

/// exp(m) by its series, enough for norms below 1.
Tensor<2, 3> exponential(const SymmetricTensor<2, 3> &m)
{
  Tensor<2, 3> sum = one, term = one;
  for (unsigned k = 1; k < 30; ++k) {
    term = term * Tensor<2, 3>(m) / k;
    sum += term;
  }
  return sum;
}

TEST(Corotation, RotationTimesStretchIsTheIncrement)
{
  for (const auto &F : increments()) {
    const Corotation corotation(F);
    ASSERT_TRUE(corotation.is_possible());
    // F = R U: what R turns U into, V = R U R^T, has V^2 = F F^T.
    const auto U = exponential(corotation.log_stretch());
    const auto V = corotation.rotate(symmetrize(U));
    EXPECT_LT((U * U - transpose(F) * F).norm(), 1e-13); // round-off
    const Tensor<2, 3> left(V);
    EXPECT_LT((left * left - F * transpose(F)).norm(), 1e-13);
  }
}

TEST(Corotation, TangentIsTheSlope)
{
  // A stress linear in ln U, with a slope that has no symmetry but its minor
  // ones.
  CorotatedStress start;
  for (unsigned k = 0; k < 6; ++k) {
    start.stress.access_raw_entry(k) = std::cos(1. + k);
    for (unsigned j = 0; j < 6; ++j)
      start.by_log_stretch.access_raw_entry(6 * k + j) =
          std::sin(1. + k * 7 + j * 3);
  }
  const auto answer = [&](const Corotation &corotation) {
    CorotatedStress result = start;
    result.stress += start.by_log_stretch * corotation.log_stretch();
    return result;
  };
  for (const auto &F : increments()) {
    const Corotation corotation(F);
    const auto tangent = corotation.tangent(answer(corotation));
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = i; j < 3; ++j) {
        const double h = 1e-5;
        Tensor<2, 3> strain;
        strain[i][j] += 0.5;
        strain[j][i] += 0.5;
        const Corotation ahead((one + h * strain) * F),
            behind((one - h * strain) * F);
        const auto slope = (ahead.rotate(answer(ahead).stress) -
                            behind.rotate(answer(behind).stress)) /
                           (2 * h);
        // h^2 and round-off over h, both 1e-10.
        EXPECT_LT((tangent * symmetrize(strain) - slope).norm(), 1e-8)
            << i << j;
      }
  }
}

TEST(Corotation, RefusesWhatTurnsInsideOut)
{
  Tensor<2, 3> F = one;
  F[1][1] = -1;
  EXPECT_FALSE(Corotation(F).is_possible());
  F[1][1] = std::nan("");
  EXPECT_FALSE(Corotation(F).is_possible());
}
} // namespace
} // namespace tamp::fem
