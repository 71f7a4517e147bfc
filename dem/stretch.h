// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_stretch_h
#define dem_stretch_h

#include <dem/tensors.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace tamp::dem
{
/// ln U of a symmetric positive definite U.
inline Matrix3 logarithm(const Matrix3 &stretch)
{
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(stretch);
  return eigen.eigenvectors() *
         eigen.eigenvalues().array().log().matrix().asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// exp E of a symmetric E; exactly diagonal if E is.
inline Matrix3 exponential(const Matrix3 &strain)
{
  if (strain.isDiagonal(0))
    return strain.diagonal().array().exp().matrix().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix3> eigen(strain);
  return eigen.eigenvectors() *
         eigen.eigenvalues().array().exp().matrix().asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// Largest principal value by magnitude of a symmetric matrix.
inline double largest_principal(const Matrix3 &strain)
{
  return Eigen::SelfAdjointEigenSolver<Matrix3>(strain, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .cwiseAbs()
      .maxCoeff();
}
} // namespace tamp::dem

#endif
