// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_polar_h
#define coupling_polar_h

#include <dem/tangent.h>
#include <dem/tensors.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace tamp::coupling
{
using Tangent4 = dealii::SymmetricTensor<4, 3>;

/// F = rotation stretch, the stretch symmetric.
struct PolarSplit {
  dem::Matrix3 rotation, stretch;
};

/// Splits a deformation gradient with positive determinant, to round-off. A
/// gradient that is symmetric positive definite to the last bit is its own
/// stretch. Throws std::domain_error if the determinant is not positive.
PolarSplit polar_split(const dem::Matrix3 &F);

dem::Matrix3 to_matrix(const dealii::Tensor<2, 3> &tensor);
/// The symmetric part.
dealii::SymmetricTensor<2, 3> to_tensor(const dem::Matrix3 &matrix);
Tangent4 to_tangent(const dem::Tangent &tangent);
/// The map seen from a frame turned by `rotation`.
Tangent4 turned(const Tangent4 &tangent, const dem::Matrix3 &rotation);
} // namespace tamp::coupling

#endif
