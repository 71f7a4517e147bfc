// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_corotation_h
#define fem_laws_corotation_h

#include <fem/material_points.h>

#include <array>

namespace tamp::fem
{
/// Stress in the frame that does not turn, and its derivative by the
/// logarithmic stretch [Pa].
struct CorotatedStress {
  dealii::SymmetricTensor<2, 3> stress;
  dealii::SymmetricTensor<4, 3> by_log_stretch;
};

/// An increment dF = R U, told as the pure rotation R and the logarithmic
/// stretch ln U. A law that answers with the stress S(ln U) in the frame of the
/// old configuration is objective by construction: the Cauchy stress is R S
/// R^T.
class Corotation
{
public:
  /// @param relative_F  dF [-]; an increment with non-finite entries or with
  ///                    det dF <= 0 leaves `is_possible()` false.
  explicit Corotation(const dealii::Tensor<2, 3> &relative_F);

  bool is_possible() const { return is_possible_; }
  /// ln U [-].
  const dealii::SymmetricTensor<2, 3> &log_stretch() const
  {
    return log_stretch_;
  }
  /// det dF [-].
  double volume_ratio() const { return volume_ratio_; }

  /// R S R^T [Pa].
  dealii::SymmetricTensor<2, 3>
  rotate(const dealii::SymmetricTensor<2, 3> &corotated) const;

  /// d(R S R^T) / d strain for dF -> (I + strain) dF [Pa], exact: the
  /// derivatives of ln U and R are those of isotropic tensor functions
  /// (Daleckii and Krein 1965).
  dealii::SymmetricTensor<4, 3> tangent(const CorotatedStress &answer) const;

private:
  bool is_possible_ = false;
  double volume_ratio_ = 0;
  dealii::Tensor<2, 3> rotation_;
  dealii::SymmetricTensor<2, 3> log_stretch_;
  std::array<double, 3> logarithm_{}; ///< eigenvalues of ln U
  dealii::Tensor<2, 3> axes_;         ///< row i: the eigenvector n_i
  dealii::Tensor<2, 3> spatial_axes_; ///< column i: R n_i
};
} // namespace tamp::fem

#endif
