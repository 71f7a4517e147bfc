// SPDX-License-Identifier: BSD-3-Clause
#include <fem/stress_search.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tamp::fem::path
{
using dealii::SymmetricTensor;
using dealii::Tensor;

namespace
{
// xx, yy, zz, yz, xz, xy.
constexpr std::array<std::array<unsigned, 2>, 6> entry{
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

/// Gaussian elimination with row exchange; none if the matrix is singular.
std::optional<std::vector<double>> solve(std::vector<std::vector<double>> a,
                                         std::vector<double> b)
{
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k]))
        pivot = i;
    if (!(std::abs(a[pivot][k]) > 0))
      return {};
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double ratio = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j)
        a[i][j] -= ratio * a[k][j];
      b[i] -= ratio * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j)
      b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
    if (!std::isfinite(b[k]))
      return {};
  }
  return b;
}

double norm(const std::vector<double> &values)
{
  double result = 0;
  for (const double value : values)
    result = std::max(result, std::abs(value));
  return result;
}
} // namespace

Tensor<2, 3> increment(const Tensor<2, 3> &F_new, const Tensor<2, 3> &F_old)
{
  double off = 0;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      if (i != j)
        off = std::max({off, std::abs(F_new[i][j]), std::abs(F_old[i][j])});
  if (off > 0)
    return F_new * invert(F_old);
  Tensor<2, 3> result;
  for (unsigned i = 0; i < 3; ++i)
    result[i][i] = F_new[i][i] / F_old[i][i];
  return result;
}

Six components(const SymmetricTensor<2, 3> &tensor)
{
  Six result;
  for (unsigned i = 0; i < 6; ++i)
    result[i] = tensor[entry[i][0]][entry[i][1]];
  return result;
}

double largest(const Six &values)
{
  double result = 0;
  for (const double value : values)
    result = std::max(result, std::abs(value));
  return result;
}

Six difference(const Six &a, const Six &b)
{
  Six result;
  for (unsigned i = 0; i < 6; ++i)
    result[i] = a[i] - b[i];
  return result;
}

Tensor<2, 3> stretch(const Six &strain)
{
  Tensor<2, 3> result;
  if (largest({strain[3], strain[4], strain[5]}) <= 0) {
    for (unsigned i = 0; i < 3; ++i)
      result[i][i] = std::exp(strain[i]);
    return result;
  }
  SymmetricTensor<2, 3> E;
  for (unsigned i = 0; i < 6; ++i)
    E[entry[i][0]][entry[i][1]] = strain[i];
  for (const auto &[value, axis] : dealii::eigenvectors(
           E, dealii::SymmetricTensorEigenvectorMethod::jacobi))
    result += std::exp(value) * outer_product(axis, axis);
  return result;
}

LeftSplit left_split(const Tensor<2, 3> &F)
{
  LeftSplit split{};
  split.rotation = dealii::unit_symmetric_tensor<3>();
  const SymmetricTensor<2, 3> b = symmetrize(F * transpose(F));
  if (largest({b[1][2], b[0][2], b[0][1], 0, 0, 0}) <= 0) {
    for (unsigned i = 0; i < 3; ++i)
      split.strain[i] = 0.5 * std::log(b[i][i]);
  } else {
    SymmetricTensor<2, 3> E;
    for (const auto &[value, axis] : dealii::eigenvectors(
             b, dealii::SymmetricTensorEigenvectorMethod::jacobi))
      E += 0.5 * std::log(value) * symmetrize(outer_product(axis, axis));
    split.strain = components(E);
  }
  double off = 0;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      off = i == j ? off : std::max(off, std::abs(F[i][j]));
  if (off > 0)
    split.rotation = invert(stretch(split.strain)) * F;
  return split;
}

Probe::Probe(MaterialPoints &points)
    : points_(points), F_(dealii::unit_symmetric_tensor<3>()), trial_F_(F_),
      deformations_(points.size(), {F_}), responses_(points.size())
{
  AssertThrow(points.size() > 0,
              dealii::ExcMessage("a path needs a material point"));
}

const Response &Probe::evaluate(const Tensor<2, 3> &F, const Want want)
{
  evaluate_increment(increment(F, F_), want);
  trial_F_ = F;
  return responses_[0];
}

const Response &Probe::evaluate_increment(const Tensor<2, 3> &relative_F,
                                          const Want want)
{
  trial_F_ = relative_F * F_;
  deformations_[0].relative_F = relative_F;
  points_.evaluate(deformations_, want, responses_);
  return responses_[0];
}

void Probe::commit()
{
  points_.commit();
  F_ = trial_F_;
}

bool StressSearch::find(Six &strain)
{
  probe_.begin_attempt();
  constexpr unsigned iterations = 40, refresh = 10;
  strain_ = strain;
  for (unsigned i = 0; i < 6; ++i)
    if (std::find(goal_.free.begin(), goal_.free.end(), i) == goal_.free.end())
      strain_[i] = goal_.strain[i];
  hold_axis(strain_);
  for (unsigned iteration = 0; iteration < iterations; ++iteration) {
    if (iteration % refresh == 0) {
      const bool strain_only = goal_.free.empty();
      if (!evaluate(strain_,
                    strain_only ? Want::stress : Want::stress_and_tangent))
        return false;
      residual_ = trial_residual_;
      if (!strain_only)
        take_tangent();
    }
    if (norm(residual_) <= goal_.tolerance * scale()) {
      strain = strain_;
      return true;
    }
    if (!correct())
      return false;
  }
  return false;
}

bool StressSearch::evaluate(const Six &strain, const Want want)
{
  const Response &response =
      probe_.evaluate(stretch(strain) * goal_.rotation, want);
  const Six stress = components(response.stress);
  trial_residual_.clear();
  for (const unsigned i : goal_.free)
    trial_residual_.push_back(stress[i] + goal_.axial_share * stress[2] -
                              goal_.stress[i]);
  return response.status != Status::failed && std::isfinite(largest(stress));
}

// Where zz is prescribed in relation to xx and yy, it goes with them.
void StressSearch::hold_axis(Six &strain) const
{
  if (goal_.deviatoric)
    strain[2] = goal_.strain[2] + 0.5 * (strain[0] + strain[1]);
}

double StressSearch::scale() const
{
  const double now = largest(components(probe_.response().stress));
  return std::max(now, goal_.stress_scale);
}

// The derivative by the components of the logarithmic strain, for which the
// tangent is exact in the limit of small strains and a good start otherwise.
void StressSearch::take_tangent()
{
  const auto &tangent = probe_.response().tangent;
  const std::size_t n = goal_.free.size();
  slope_.assign(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const auto &[a, b] = entry[goal_.free[i]];
      const auto &[c, d] = entry[goal_.free[j]];
      const auto slope = [&](unsigned k, unsigned l) {
        return tangent[a][b][k][l] + goal_.axial_share * tangent[2][2][k][l];
      };
      slope_[i][j] = slope(c, d) * (c == d ? 1 : 2);
      if (goal_.deviatoric && goal_.free[j] < 2)
        slope_[i][j] += 0.5 * slope(2, 2);
    }
}

std::vector<double> StressSearch::correction() const
{
  auto step = solve(slope_, residual_);
  const double most = goal_.largest_correction;
  if (!step) // a point without stiffness: go where the stress asks for
    step = residual_;
  const double size = norm(*step);
  const double factor = !(size > most) ? 1 : most / size;
  for (double &value : *step)
    value *= -factor;
  return *step;
}

bool StressSearch::correct()
{
  std::vector<double> step = correction();
  const double before = norm(residual_);
  for (unsigned halving = 0; halving < 6; ++halving) {
    Six trial = strain_;
    for (std::size_t i = 0; i < step.size(); ++i)
      trial[goal_.free[i]] += step[i];
    hold_axis(trial);
    if (evaluate(trial, Want::stress) && norm(trial_residual_) < 1.5 * before) {
      update(step);
      strain_ = trial;
      residual_ = trial_residual_;
      return true;
    }
    for (double &value : step)
      value *= 0.5;
  }
  return false;
}

void StressSearch::update(const std::vector<double> &step)
{
  double square = 0;
  for (const double value : step)
    square += value * value;
  if (!(square > 0))
    return;
  for (std::size_t i = 0; i < step.size(); ++i) {
    double miss = trial_residual_[i] - residual_[i];
    for (std::size_t j = 0; j < step.size(); ++j)
      miss -= slope_[i][j] * step[j];
    for (std::size_t j = 0; j < step.size(); ++j)
      slope_[i][j] += miss * step[j] / square;
  }
}
} // namespace tamp::fem::path
