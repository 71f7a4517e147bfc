// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_residual_model_h
#define apps_calibrate_residual_model_h

#include <apps/calibrate/surrogate_search.h>

#include <Eigen/Dense>

#include <cstddef>
#include <vector>

namespace tamp::apps
{
/// Each residual as a quadratic of the place, about a centre.
class ResidualModel
{
public:
  /// Regression over the samples that did not fail, those farther from the
  /// centre than `radius` counting less and less.
  ResidualModel(const std::vector<SearchSample> &samples,
                const Eigen::VectorXd &centre,
                double radius);

  Eigen::VectorXd residuals(const Eigen::VectorXd &place) const;
  /// d residuals / d place.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd &place) const;

  /// The place of the least sum of squares within a box, looked for from a
  /// start in it.
  Eigen::VectorXd least(const Eigen::VectorXd &start,
                        const Eigen::VectorXd &low,
                        const Eigen::VectorXd &high) const;

private:
  Eigen::VectorXd centre_;
  double radius_;
  Eigen::MatrixXd coefficients_; ///< a row for each term, columns: residuals
};

/// Coefficients of a quadratic of so many variables.
std::size_t quadratic_terms(std::size_t dimension);
} // namespace tamp::apps

#endif
