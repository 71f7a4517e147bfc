// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/corotation.h>

#include <cmath>

namespace tamp::fem
{
namespace
{
using dealii::SymmetricTensor;
using dealii::Tensor;

/// The two indices of each entry of a symmetric tensor, in deal.II's order.
constexpr std::array<std::array<unsigned, 2>, 6> pairs{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
/// And back.
constexpr std::array<std::array<unsigned, 3>, 3> entry{
    {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}}};

/// A tensor of rank four with both minor symmetries, entries as in `pairs`.
using Matrix6 = std::array<std::array<double, 6>, 6>;

/// x / sinh(x) and tanh(x / 2); below 0.02 the series are exact to round-off.
double over_sinh(const double x)
{
  const double s = x * x;
  return s < 4e-4 ? 1 - s / 6 * (1 - s * 7 / 60 * (1 - s * 31 / 294))
                  : x / std::sinh(x);
}
double tanh_of_half(const double x)
{
  const double s = x * x;
  return s < 4e-4 ? x / 2 * (1 - s / 12 * (1 - s / 10 * (1 - s * 17 / 168)))
                  : std::tanh(x / 2);
}

/// Eigenvalues and, as rows of `axes`, eigenvectors of a symmetric tensor.
struct Principal {
  std::array<double, 3> value;
  Tensor<2, 3> axes;
};

/// Of a tensor whose only entry off the diagonal is ij: one rotation of Jacobi.
Principal principal_in_plane(const SymmetricTensor<2, 3> &m,
                             const unsigned i,
                             const unsigned j)
{
  Principal result{{m[0][0], m[1][1], m[2][2]},
                   Tensor<2, 3>(dealii::unit_symmetric_tensor<3>())};
  if (!(std::abs(m[i][j]) > 0))
    return result;
  const double ratio = (m[j][j] - m[i][i]) / (2 * m[i][j]);
  const double tangent = std::copysign(
      1 / (std::abs(ratio) + std::sqrt(ratio * ratio + 1)), ratio);
  const double cosine = 1 / std::sqrt(tangent * tangent + 1);
  const double sine = tangent * cosine;
  result.value[i] -= tangent * m[i][j];
  result.value[j] += tangent * m[i][j];
  result.axes[i][i] = result.axes[j][j] = cosine;
  result.axes[i][j] = -sine;
  result.axes[j][i] = sine;
  return result;
}

Principal principal(const SymmetricTensor<2, 3> &m)
{
  unsigned count = 0, plane = 3;
  for (unsigned k = 3; k < 6; ++k)
    if (std::abs(m.access_raw_entry(k)) > 0) {
      ++count;
      plane = k;
    }
  if (count <= 1)
    return principal_in_plane(m, pairs[plane][0], pairs[plane][1]);
  const auto eigen =
      dealii::eigenvectors(m, dealii::SymmetricTensorEigenvectorMethod::jacobi);
  Principal result;
  for (unsigned i = 0; i < 3; ++i) {
    result.value[i] = eigen[i].first;
    result.axes[i] = eigen[i].second;
  }
  return result;
}

/// What takes the entries of x to those of m x m^T.
Matrix6 frame_change(const Tensor<2, 3> &m)
{
  Matrix6 result;
  for (unsigned r = 0; r < 6; ++r)
    for (unsigned c = 0; c < 6; ++c) {
      const auto [i, j] = pairs[r];
      const auto [a, b] = pairs[c];
      result[r][c] = m[i][a] * m[j][b] + (c < 3 ? 0 : m[i][b] * m[j][a]);
    }
  return result;
}

/// m x m^T.
Matrix6 turned(const Matrix6 &m, const Matrix6 &x)
{
  Matrix6 half{}, result{};
  for (unsigned i = 0; i < 6; ++i)
    for (unsigned k = 0; k < 6; ++k)
      for (unsigned j = 0; j < 6; ++j)
        half[i][j] += m[i][k] * x[k][j];
  Matrix6 transposed;
  for (unsigned i = 0; i < 6; ++i)
    for (unsigned j = 0; j < 6; ++j)
      transposed[i][j] = m[j][i];
  for (unsigned i = 0; i < 6; ++i)
    for (unsigned k = 0; k < 6; ++k)
      for (unsigned j = 0; j < 6; ++j)
        result[i][j] += half[i][k] * transposed[k][j];
  return result;
}
} // namespace

Corotation::Corotation(const Tensor<2, 3> &relative_F)
    : volume_ratio_(determinant(relative_F))
{
  if (!std::isfinite(relative_F.norm_square()) || !(volume_ratio_ > 0))
    return;
  const auto [square, axes] =
      principal(symmetrize(transpose(relative_F) * relative_F));
  std::array<double, 3> inverse;
  for (unsigned i = 0; i < 3; ++i) {
    if (!(square[i] > 0))
      return;
    logarithm_[i] = 0.5 * std::log(square[i]);
    inverse[i] = 1 / std::sqrt(square[i]);
  }
  axes_ = axes;
  spatial_axes_ = relative_F * transpose(axes);
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      spatial_axes_[i][j] *= inverse[j];
  rotation_ = spatial_axes_ * axes;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = i; j < 3; ++j)
      log_stretch_[i][j] = logarithm_[0] * axes[0][i] * axes[0][j] +
                           logarithm_[1] * axes[1][i] * axes[1][j] +
                           logarithm_[2] * axes[2][i] * axes[2][j];
  is_possible_ = true;
}

SymmetricTensor<2, 3>
Corotation::rotate(const SymmetricTensor<2, 3> &corotated) const
{
  return symmetrize(rotation_ * Tensor<2, 3>(corotated) * transpose(rotation_));
}

// In the principal axes n of U and R n of the new configuration a symmetric
// strain g changes ln U by (t / sinh t) g_ij and turns by -tanh(t / 2) g_ij
// with t = ln(lambda_i / lambda_j).
SymmetricTensor<4, 3> Corotation::tangent(const CorotatedStress &answer) const
{
  const Matrix6 to_axes = frame_change(axes_);
  Matrix6 slope;
  std::array<double, 6> stress{};
  for (unsigned i = 0; i < 6; ++i)
    for (unsigned j = 0; j < 6; ++j) {
      slope[i][j] = answer.by_log_stretch.access_raw_entry(6 * i + j);
      stress[i] += to_axes[i][j] * answer.stress.access_raw_entry(j);
    }
  slope = turned(to_axes, slope);
  for (unsigned k = 3; k < 6; ++k) {
    const auto [a, b] = pairs[k];
    const double t = logarithm_[a] - logarithm_[b];
    const double shrink = over_sinh(t), turn = 0.5 * tanh_of_half(t);
    for (unsigned i = 0; i < 6; ++i)
      slope[i][k] *= shrink;
    // Half of spin * stress - stress * spin, for a strain in the plane ab.
    for (unsigned j = 0; j < 3; ++j) {
      slope[entry[a][j]][k] -= (j == a ? 2 : 1) * turn * stress[entry[b][j]];
      slope[entry[b][j]][k] += (j == b ? 2 : 1) * turn * stress[entry[a][j]];
    }
  }
  slope = turned(frame_change(spatial_axes_), slope);
  SymmetricTensor<4, 3> result;
  for (unsigned i = 0; i < 6; ++i)
    for (unsigned j = 0; j < 6; ++j)
      result.access_raw_entry(6 * i + j) = slope[i][j];
  return result;
}
} // namespace tamp::fem
