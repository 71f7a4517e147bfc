// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/residual_model.h>
#include <apps/calibrate/surrogate_search.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
using Eigen::VectorXd;

constexpr double first_radius = 0.3, largest_radius = 0.5;
constexpr double slope_radius = 0.05; // of the regression for the Jacobian
constexpr double settled = 1e-3; // a step, or a share of the cost to be gained
constexpr std::size_t candidates = 64;

// Member `k` of the R sequence, evenly spread over the unit cube: multiples of
// the inverse powers of the root of x^(n+1) = x + 1, modulo 1. M. Roberts, The
// unreasonable effectiveness of quasirandom sequences (2018).
VectorXd spread(std::size_t dimension, std::size_t k)
{
  double root = 2;
  for (int i = 0; i < 60; ++i)
    root = std::pow(1 + root, 1 / (1 + static_cast<double>(dimension)));
  VectorXd place(static_cast<Eigen::Index>(dimension));
  double step = 1;
  for (double &coordinate : place) {
    step /= root;
    double whole = 0;
    coordinate = std::modf(0.5 + step * static_cast<double>(k), &whole);
  }
  return place;
}

/// One search.
class Search
{
public:
  Search(const SearchLimits &limits, const EvaluatePlaces &evaluate)
      : limits_(limits), evaluate_(evaluate)
  {
  }

  SearchEnd run()
  {
    survey();
    const auto usable = std::ranges::count_if(
        end_.samples, [](const SearchSample &s) { return !s.failed(); });
    if (usable < 2 + static_cast<std::ptrdiff_t>(limits_.dimension))
      throw std::runtime_error("too many runs of the survey failed; narrower "
                               "bounds may help");
    while (radius_ >= limits_.smallest_radius &&
           end_.samples.size() + 1 + limits_.dimension <= limits_.most_runs)
      if (refine()) {
        end_.converged = true;
        break;
      }
    end_.converged |= radius_ < limits_.smallest_radius;
    const VectorXd &best = end_.samples[end_.best].place;
    end_.jacobian =
        ResidualModel(end_.samples, best, std::max(radius_, slope_radius))
            .jacobian(best);
    return end_;
  }

private:
  void make(const std::vector<VectorXd> &places, bool is_survey)
  {
    const auto residuals = evaluate_(places, is_survey);
    for (std::size_t i = 0; i < places.size(); ++i) {
      end_.samples.push_back({places[i], residuals[i]});
      if (end_.samples.back().cost() < end_.samples[end_.best].cost())
        end_.best = end_.samples.size() - 1;
    }
  }

  void survey()
  {
    std::vector<VectorXd> places;
    for (std::size_t k = 0; k < survey_size(limits_.dimension); ++k)
      places.push_back(spread(limits_.dimension, k));
    make(places, true);
  }

  /// The place in a box that is farthest from all runs and from `others`.
  VectorXd sparse(const VectorXd &low,
                  const VectorXd &high,
                  const std::vector<VectorXd> &others)
  {
    VectorXd farthest = 0.5 * (low + high);
    double most = -1;
    for (std::size_t k = 0; k < candidates; ++k) {
      const VectorXd place =
          low + spread(limits_.dimension, ++drawn_).cwiseProduct(high - low);
      double nearest = std::numeric_limits<double>::infinity();
      for (const SearchSample &sample : end_.samples)
        nearest = std::min(nearest, (sample.place - place).norm());
      for (const VectorXd &other : others)
        nearest = std::min(nearest, (other - place).norm());
      if (nearest > most) {
        most = nearest;
        farthest = place;
      }
    }
    return farthest;
  }

  /// One batch; true if no more is to be gained.
  bool refine()
  {
    const SearchSample centre = end_.samples[end_.best];
    const ResidualModel model(end_.samples, centre.place, radius_);
    const VectorXd one = VectorXd::Ones(centre.place.size());
    const auto around = [&](const VectorXd &middle, double radius) {
      return std::pair<VectorXd, VectorXd>(
          (middle - radius * one).cwiseMax(0.0),
          (middle + radius * one).cwiseMin(1.0));
    };
    const auto [low, high] = around(centre.place, radius_);
    const VectorXd least = model.least(centre.place, low, high);
    const double step = (least - centre.place).lpNorm<Eigen::Infinity>();
    const double gain = centre.cost() - model.residuals(least).squaredNorm();

    std::vector<VectorXd> places{least};
    const auto [inner_low, inner_high] = around(least, 0.5 * radius_);
    for (std::size_t i = 0; i < limits_.dimension; ++i)
      places.push_back(sparse(inner_low, inner_high, places));
    const std::size_t first = end_.samples.size();
    make(places, false);

    const double gained = centre.cost() - end_.samples[first].cost();
    const bool good = gained > 0.5 * gain && gain > 0;
    if (good && step > 0.9 * radius_)
      radius_ = std::min(largest_radius, 2 * radius_);
    else if (!good || step < 0.5 * radius_)
      radius_ /= good ? 3 : 2;
    return step < settled && std::abs(gain) < settled * centre.cost() &&
           end_.best < first;
  }

  const SearchLimits &limits_;
  const EvaluatePlaces &evaluate_;
  SearchEnd end_;
  double radius_ = first_radius;
  std::size_t drawn_ = 0; ///< of the sequence, for places where runs are sparse
};
} // namespace

double SearchSample::cost() const
{
  return failed() ? std::numeric_limits<double>::infinity()
                  : residuals.squaredNorm();
}

std::size_t survey_size(std::size_t dimension)
{
  return quadratic_terms(dimension) + dimension + 1;
}

SearchEnd search_least_squares(const SearchLimits &limits,
                               const EvaluatePlaces &evaluate)
{
  return Search(limits, evaluate).run();
}
} // namespace tamp::apps
