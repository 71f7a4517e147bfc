// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_fit_confidence_h
#define apps_calibrate_fit_confidence_h

#include <apps/calibrate/fit_parameter.h>
#include <apps/calibrate/surrogate_search.h>

#include <Eigen/Dense>

#include <string>
#include <vector>

namespace tamp::apps
{
/// What is known of a parameter.
struct FitEstimate {
  double value = 0;          ///< in SI
  double standard_error = 0; ///< in SI, where the slope is that at the value
  double low = 0, high = 0;  ///< 95 % interval, cut at the bounds, in SI
  bool at_bound = false;     ///< the value is one of its bounds, or next to it
  bool flat = false;         ///< the data hardly narrow the bounds down
  /// Is the 95 % interval within 10 % of the value to both sides?
  bool determined = false;
};

/// Estimates with their errors and how these hang together.
struct FitConfidence {
  std::vector<FitEstimate> estimates;
  Eigen::MatrixXd correlation;
  double noise = 0; ///< standard deviation of a residual [-]
  /// Residuals next to each other are alike: so many of them count as one.
  double alike = 1;
};

/// How estimates from several packings differ.
struct FitScatter {
  unsigned packings = 1;
  /// Covariance of the place found with one of them; empty if there are no
  /// others.
  Eigen::MatrixXd covariance;
};

/// Errors from the curvature of the sum of squares, J^T J, at its least. The
/// scatter of the residuals is taken for noise, whether the measurement or the
/// model has it, and noise of neighbours for as alike as the residuals are
/// (AR(1)). Being within the bounds counts as knowledge, too, of the variance
/// of an even distribution between them, so that what the data cannot tell has
/// the bounds for an interval. To that comes the variance of the mean of
/// several packings, if there are. Source: G. A. F. Seber, C. J. Wild,
/// Nonlinear Regression (1989), ch. 5, 6.
FitConfidence confidence_of(const std::vector<FitParameter> &parameters,
                            const SearchSample &best,
                            const Eigen::MatrixXd &jacobian,
                            const FitScatter &scatter = {});

/// What is to be said of a fit.
struct FitSentence {
  std::string text;
  bool doubt = false; ///< the data tell too little
};

/// A sentence for each parameter, and one for each pair that trades off.
std::vector<FitSentence>
confidence_words(const std::vector<FitParameter> &parameters,
                 const FitConfidence &confidence);
} // namespace tamp::apps

#endif
