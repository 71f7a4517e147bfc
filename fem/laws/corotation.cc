// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/corotation.h>

#include <cmath>

namespace tamp::fem
{
namespace
{
using dealii::SymmetricTensor;
using dealii::Tensor;

/// (ln a - ln b) / (a - b), also where a = b.
double divided_logarithm(const double a, const double b)
{
  const double t = (a - b) / b;
  return (std::abs(t) < 1e-8 ? 1 - t / 2 : std::log1p(t) / t) / b;
}
} // namespace

Corotation::Corotation(const Tensor<2, 3> &relative_F)
    : volume_ratio_(determinant(relative_F)), relative_F_(relative_F)
{
  if (!std::isfinite(relative_F.norm()) || !(volume_ratio_ > 0))
    return;
  const auto eigen =
      dealii::eigenvectors(symmetrize(transpose(relative_F) * relative_F),
                           dealii::SymmetricTensorEigenvectorMethod::jacobi);
  for (unsigned i = 0; i < 3; ++i) {
    const auto &[square, axis] = eigen[i];
    if (!(square > 0))
      return;
    square_[i] = square;
    const auto dyad = outer_product(axis, axis);
    log_stretch_ += 0.5 * std::log(square) * symmetrize(dyad);
    inverse_stretch_ += dyad / std::sqrt(square);
    for (unsigned j = 0; j < 3; ++j)
      axes_[i][j] = axis[j];
  }
  rotation_ = relative_F * inverse_stretch_;
  is_possible_ = true;
}

SymmetricTensor<2, 3>
Corotation::rotate(const SymmetricTensor<2, 3> &corotated) const
{
  return symmetrize(rotation_ * Tensor<2, 3>(corotated) * transpose(rotation_));
}

SymmetricTensor<4, 3> Corotation::tangent(const CorotatedStress &answer) const
{
  const Tensor<2, 3> stress(rotate(answer.stress));
  SymmetricTensor<4, 3> result;
  for (unsigned k = 0; k < 6; ++k) {
    // The derivative along (e_a e_b + e_b e_a) / 2 is the column ..ab.
    const auto ab = SymmetricTensor<2, 3>::unrolled_to_component_indices(k);
    Tensor<2, 3> strain;
    strain[ab[0]][ab[1]] += 0.5;
    strain[ab[1]][ab[0]] += 0.5;

    const Tensor<2, 3> square_change = axes_ * transpose(relative_F_) *
                                       (2 * strain) * relative_F_ *
                                       transpose(axes_);
    Tensor<2, 3> log_change, stretch_change;
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = 0; j < 3; ++j) {
        log_change[i][j] = 0.5 * square_change[i][j] *
                           divided_logarithm(square_[i], square_[j]);
        stretch_change[i][j] = square_change[i][j] /
                               (std::sqrt(square_[i]) + std::sqrt(square_[j]));
      }
    log_change = transpose(axes_) * log_change * axes_;
    stretch_change = transpose(axes_) * stretch_change * axes_;
    const Tensor<2, 3> spin =
        (strain * relative_F_ - rotation_ * stretch_change) * inverse_stretch_ *
        transpose(rotation_);

    const SymmetricTensor<2, 3> change =
        rotate(answer.by_log_stretch * symmetrize(log_change)) +
        symmetrize(spin * stress + stress * transpose(spin));
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = i; j < 3; ++j)
        result[i][j][ab[0]][ab[1]] = change[i][j];
  }
  return result;
}
} // namespace tamp::fem
