// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_surrogate_search_h
#define apps_calibrate_surrogate_search_h

#include <Eigen/Dense>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace tamp::apps
{
/// A place in the unit cube and the residuals there; none: the run failed.
struct SearchSample {
  Eigen::VectorXd place;
  Eigen::VectorXd residuals;

  bool failed() const { return residuals.size() == 0; }
  /// Sum of squares; infinite if the run failed.
  double cost() const;
};

/// How far a search goes.
struct SearchLimits {
  std::size_t dimension = 1;
  std::size_t most_runs = 60;
  double smallest_radius = 0.01; ///< of the trust region [-]
};

/// How a search ended.
struct SearchEnd {
  std::vector<SearchSample> samples; ///< in the order of the runs
  std::size_t best = 0;              ///< the run of least cost
  /// d residuals / d place at the best run, by regression over its neighbours.
  Eigen::MatrixXd jacobian;
  bool converged = false; ///< not stopped by the number of runs
};

/// Computes the residuals at some places, in any order and at the same time;
/// those of a run that fails are empty. The second argument tells whether the
/// places belong to the first survey.
using EvaluatePlaces = std::function<std::vector<Eigen::VectorXd>(
    const std::vector<Eigen::VectorXd> &, bool survey)>;

/// Looks for the least sum of squares in the unit cube, with few and costly
/// runs that have some noise, several at a time. A survey of the whole cube (R
/// sequence) is followed by batches in a trust region: each residual is a
/// quadratic of the place, found by regression over the runs in and near the
/// region; Ceres minimises the sum of their squares within it; the batch is
/// that place and, to keep the regression well-posed, one more per dimension
/// where runs are sparse. Modelling each residual instead of their sum needs
/// the fewest runs for least squares, its slopes are the Jacobian, and
/// regression averages noise that differences would take for slope.
/// Deterministic. Throws std::runtime_error if too many runs fail.
/// Sources: H. Zhang, A. R. Conn, K. Scheinberg, SIAM J. Optim. 20 (2010) 3555
/// (quadratic model of each residual); C. Cartis, J. Fiala, B. Marteau,
/// L. Roberts, ACM Trans. Math. Softw. 45 (2019) 32 (regression, noise).
SearchEnd search_least_squares(const SearchLimits &limits,
                               const EvaluatePlaces &evaluate);

/// How many runs the survey makes: more than a quadratic has coefficients.
std::size_t survey_size(std::size_t dimension);
} // namespace tamp::apps

#endif
