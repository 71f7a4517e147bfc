// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/polar.h>
#include <dem/six.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <stdexcept>

namespace tamp::coupling
{
PolarSplit polar_split(const dem::Matrix3 &F)
{
  if (!(F.determinant() > 0))
    throw std::domain_error("deformation gradient turned inside out");
  if (F == F.transpose() && F.llt().info() == Eigen::Success)
    return {dem::Matrix3::Identity(), F};
  const Eigen::SelfAdjointEigenSolver<dem::Matrix3> squares(F.transpose() * F);
  const dem::Matrix3 &axes = squares.eigenvectors();
  const dem::Vector3 lengths = squares.eigenvalues().cwiseSqrt();
  PolarSplit split;
  split.stretch = axes * lengths.asDiagonal() * axes.transpose();
  split.rotation =
      F * (axes * lengths.cwiseInverse().asDiagonal() * axes.transpose());
  // One step of Newton's iteration takes the rotation to round-off.
  split.rotation =
      (0.5 * (split.rotation + split.rotation.inverse().transpose())).eval();
  const dem::Matrix3 stretch = split.rotation.transpose() * F;
  split.stretch = 0.5 * (stretch + stretch.transpose());
  return split;
}

dem::Matrix3 to_matrix(const dealii::Tensor<2, 3> &tensor)
{
  dem::Matrix3 matrix;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      matrix(a, b) = tensor[a][b];
  return matrix;
}

dealii::SymmetricTensor<2, 3> to_tensor(const dem::Matrix3 &matrix)
{
  dealii::SymmetricTensor<2, 3> tensor;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b)
      tensor[a][b] = 0.5 * (matrix(a, b) + matrix(b, a));
  return tensor;
}

Tangent4 to_tangent(const dem::Tangent &tangent)
{
  Tangent4 result;
  for (int k = 0; k < 6; ++k)
    for (int l = 0; l < 6; ++l) {
      const auto [a, b] = dem::six_places[k];
      const auto [c, d] = dem::six_places[l];
      // The strain of column l holds both of its shear entries.
      result[a][b][c][d] = (l < 3 ? 1.0 : 0.5) * tangent(k, l);
    }
  return result;
}

Tangent4 turned(const Tangent4 &tangent, const dem::Matrix3 &rotation)
{
  // Column by column: turn each unit strain back, map it, turn the stress.
  Tangent4 result;
  for (int l = 0; l < 6; ++l) {
    const auto [c, d] = dem::six_places[l];
    dem::Matrix3 strain = dem::Matrix3::Zero();
    strain(c, d) = strain(d, c) = c == d ? 1.0 : 0.5;
    const dealii::SymmetricTensor<2, 3> stress =
        tangent * to_tensor(rotation.transpose() * strain * rotation);
    const dem::Matrix3 turned_stress = rotation *
                                       to_matrix(dealii::Tensor<2, 3>(stress)) *
                                       rotation.transpose();
    for (const auto &[a, b] : dem::six_places)
      result[a][b][c][d] = turned_stress(a, b);
  }
  return result;
}
} // namespace tamp::coupling
