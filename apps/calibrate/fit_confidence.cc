// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/fit_confidence.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
constexpr double variance_of_bounds = 1.0 / 12; // even distribution, width 1
constexpr double next_to_bound = 0.01;          // of the way between the bounds
constexpr double flat_error = 0.2; // of it; 0.29 is that of the bounds alone
constexpr double narrow = 0.1;     // relative half-width of an interval
constexpr double much = 0.9, somewhat = 0.7; // correlations
constexpr double most_alike = 0.95;

// Correlation of residuals with their neighbours.
double neighbours(const Eigen::VectorXd &residuals)
{
  const auto n = residuals.size();
  const double all = residuals.squaredNorm();
  if (n < 3 || !(all > 0))
    return 0;
  return std::clamp(
      residuals.head(n - 1).dot(residuals.tail(n - 1)) / all, 0.0, most_alike);
}

// Half a 95 % interval over its standard error, where two variances with their
// degrees of freedom add up. Welch (1947), Biometrika 34:28.
double factor_of(double first, double freedom, double second, double other)
{
  const double both = first + second;
  double all = first * first / freedom;
  if (other > 0)
    all += second * second / other;
  return quantile(boost::math::students_t(std::max(1.0, both * both / all)),
                  0.975);
}

std::string number(double value, const std::string &unit)
{
  if (unit == "Pa")
    return fmt::format("{:.4g} MPa", value / 1e6);
  return unit == "-" ? fmt::format("{:.4g}", value)
                     : fmt::format("{:.4g} {}", value, unit);
}

FitSentence words(const FitParameter &parameter, const FitEstimate &estimate)
{
  const std::string value = fmt::format("{} = {}, 95 % interval {} to {}",
                                        parameter.path,
                                        number(estimate.value, parameter.unit),
                                        number(estimate.low, parameter.unit),
                                        number(estimate.high, parameter.unit));
  if (estimate.at_bound)
    return {value + ": it ended at its bound; either that is too narrow, or "
                    "the simulation cannot follow the data",
            true};
  if (estimate.flat)
    return {value + ": the data cannot tell; between its bounds any value fits "
                    "about as well",
            true};
  if (!estimate.determined)
    return {value + ": the data tell it roughly only", true};
  return {value, false};
}
} // namespace

FitConfidence confidence_of(const std::vector<FitParameter> &parameters,
                            const SearchSample &best,
                            const Eigen::MatrixXd &jacobian,
                            const FitScatter &scatter)
{
  const auto n = static_cast<Eigen::Index>(parameters.size());
  const double count = static_cast<double>(best.residuals.size());
  const double alone = neighbours(best.residuals);
  FitConfidence confidence;
  confidence.alike = (1 + alone) / (1 - alone);
  const double freedom =
      std::max(1.0, count / confidence.alike - static_cast<double>(n));
  const double variance =
      best.cost() / std::max(1.0, count - static_cast<double>(n));
  confidence.noise = std::sqrt(variance);
  // A residual of nothing at all would make everything certain.
  const double least = 1e-16;
  const Eigen::MatrixXd known =
      jacobian.transpose() * jacobian /
          (std::max(variance, least) * confidence.alike) +
      Eigen::MatrixXd::Identity(n, n) / variance_of_bounds;
  Eigen::MatrixXd covariance =
      known.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
  const Eigen::VectorXd of_noise = covariance.diagonal();
  if (scatter.covariance.size() > 0)
    covariance += scatter.covariance / scatter.packings;
  const Eigen::VectorXd error = covariance.diagonal().cwiseSqrt();
  confidence.correlation = error.cwiseInverse().asDiagonal() * covariance *
                           error.cwiseInverse().asDiagonal();
  for (Eigen::Index i = 0; i < n; ++i) {
    const FitParameter &parameter = parameters[static_cast<std::size_t>(i)];
    const double place = best.place[i];
    const double wide = factor_of(of_noise[i],
                                  freedom,
                                  error[i] * error[i] - of_noise[i],
                                  scatter.packings - 1.0);
    FitEstimate estimate;
    estimate.value = parameter.value(place);
    estimate.standard_error = error[i] * parameter.slope(place);
    estimate.low = parameter.value(place - wide * error[i]);
    estimate.high = parameter.value(place + wide * error[i]);
    estimate.at_bound = place < next_to_bound || place > 1 - next_to_bound;
    estimate.flat = error[i] > flat_error;
    // Without the cut at the bounds, which the data have no part in.
    estimate.determined = wide * error[i] * parameter.slope(place) <=
                          narrow * std::abs(estimate.value);
    confidence.estimates.push_back(estimate);
  }
  return confidence;
}

std::vector<FitSentence>
confidence_words(const std::vector<FitParameter> &parameters,
                 const FitConfidence &confidence)
{
  std::vector<FitSentence> lines;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    lines.push_back(words(parameters[i], confidence.estimates[i]));
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (std::size_t j = i + 1; j < parameters.size(); ++j) {
      const double correlation = confidence.correlation(
          static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      if (std::abs(correlation) < somewhat)
        continue;
      const bool known = confidence.estimates[i].determined &&
                         confidence.estimates[j].determined;
      lines.push_back(
          {fmt::format("{} and {} trade off: correlation {:.2f}; {}",
                       parameters[i].path,
                       parameters[j].path,
                       correlation,
                       known ? "each is told within 10 % all the same"
                       : std::abs(correlation) >= much
                           ? "the data cannot tell them apart"
                           : "the data tell them apart badly"),
           !known});
    }
  return lines;
}
} // namespace tamp::apps
