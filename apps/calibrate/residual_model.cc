// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/residual_model.h>

#include <algorithm>
#include <ceres/ceres.h>
#include <cmath>

namespace tamp::apps
{
namespace
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Keeps curvature out that the samples do not ask for.
constexpr double curvature_penalty = 1e-3;

// 1, s_i, s_i s_j (i <= j).
VectorXd terms(const VectorXd &s)
{
  const auto n = s.size();
  VectorXd all(
      static_cast<Eigen::Index>(quadratic_terms(static_cast<std::size_t>(n))));
  all[0] = 1;
  all.segment(1, n) = s;
  Eigen::Index k = 1 + n;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = i; j < n; ++j)
      all[k++] = s[i] * s[j];
  return all;
}

// d terms / d s, a column for each variable.
MatrixXd slopes(const VectorXd &s)
{
  const auto n = s.size();
  MatrixXd all = MatrixXd::Zero(
      static_cast<Eigen::Index>(quadratic_terms(static_cast<std::size_t>(n))),
      n);
  all.block(1, 0, n, n).setIdentity();
  Eigen::Index k = 1 + n;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = i; j < n; ++j, ++k) {
      all(k, i) += s[j];
      all(k, j) += s[i];
    }
  return all;
}

/// The residuals of a model for Ceres.
class ModelCost final : public ceres::CostFunction
{
public:
  ModelCost(const ResidualModel &model, int residuals, int variables)
      : model_(model)
  {
    set_num_residuals(residuals);
    mutable_parameter_block_sizes()->push_back(variables);
  }

  bool Evaluate(const double *const *parameters,
                double *residuals,
                double **jacobians) const override
  {
    const int n = parameter_block_sizes()[0];
    const VectorXd place = Eigen::Map<const VectorXd>(parameters[0], n);
    Eigen::Map<VectorXd>(residuals, num_residuals()) = model_.residuals(place);
    if (jacobians && jacobians[0])
      Eigen::Map<
          Eigen::
              Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          jacobians[0], num_residuals(), n) = model_.jacobian(place);
    return true;
  }

private:
  const ResidualModel &model_;
};
} // namespace

std::size_t quadratic_terms(std::size_t dimension)
{
  return (dimension + 1) * (dimension + 2) / 2;
}

ResidualModel::ResidualModel(const std::vector<SearchSample> &samples,
                             const VectorXd &centre,
                             double radius)
    : centre_(centre), radius_(radius)
{
  std::vector<const SearchSample *> used;
  for (const SearchSample &sample : samples)
    if (!sample.failed())
      used.push_back(&sample);
  const auto distance = [&](const SearchSample *sample) {
    return (sample->place - centre).lpNorm<Eigen::Infinity>() / radius;
  };
  std::ranges::stable_sort(used, {}, distance);
  const auto n = static_cast<std::size_t>(centre.size());
  const std::size_t unknowns = quadratic_terms(n);
  // The scale at which weights fall holds enough samples for a regression.
  const double reach =
      std::max(1.0, distance(used[std::min(used.size() - 1, unknowns)]));
  const auto rows = static_cast<Eigen::Index>(used.size()),
             columns = static_cast<Eigen::Index>(unknowns);
  MatrixXd A = MatrixXd::Zero(rows + columns, columns);
  MatrixXd b = MatrixXd::Zero(rows + columns, used[0]->residuals.size());
  for (Eigen::Index k = 0; k < rows; ++k) {
    const SearchSample &sample = *used[static_cast<std::size_t>(k)];
    const double weight =
        std::exp(-0.5 * std::pow(distance(&sample) / reach, 4));
    A.row(k) = weight * terms((sample.place - centre) / radius).transpose();
    b.row(k) = weight * sample.residuals.transpose();
  }
  for (Eigen::Index k = 1 + centre.size(); k < columns; ++k)
    A(rows + k, k) = curvature_penalty;
  coefficients_ = A.colPivHouseholderQr().solve(b);
}

VectorXd ResidualModel::residuals(const VectorXd &place) const
{
  return coefficients_.transpose() * terms((place - centre_) / radius_);
}

MatrixXd ResidualModel::jacobian(const VectorXd &place) const
{
  return coefficients_.transpose() * slopes((place - centre_) / radius_) /
         radius_;
}

VectorXd ResidualModel::least(const VectorXd &start,
                              const VectorXd &low,
                              const VectorXd &high) const
{
  VectorXd place = start.cwiseMax(low).cwiseMin(high);
  ceres::Problem problem;
  problem.AddResidualBlock(new ModelCost(*this,
                                         static_cast<int>(coefficients_.cols()),
                                         static_cast<int>(place.size())),
                           nullptr,
                           place.data());
  for (int i = 0; i < static_cast<int>(place.size()); ++i) {
    problem.SetParameterLowerBound(place.data(), i, low[i]);
    problem.SetParameterUpperBound(place.data(), i, high[i]);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.num_threads = 1;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return place.cwiseMax(low).cwiseMin(high);
}
} // namespace tamp::apps
