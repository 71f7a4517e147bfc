// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/packing_fit.h>

#include <vector>

namespace tamp::apps
{
namespace
{
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double longest_step = 0.2; // between the bounds
constexpr double worth_noise = 12;   // 1 / variance of an even distribution

/// Residuals at one place with several packings.
struct Members {
  std::vector<VectorXd> residuals;

  VectorXd mean() const
  {
    VectorXd sum = VectorXd::Zero(residuals[0].size());
    for (const VectorXd &one : residuals)
      sum += one;
    return sum / static_cast<double>(residuals.size());
  }
};

Members members_at(CalibrationRuns &runs,
                   const VectorXd &place,
                   unsigned first,
                   unsigned packings)
{
  std::vector<CalibrationPlace> places;
  for (unsigned k = first; k < packings; ++k)
    places.push_back({place, k});
  Members members;
  for (VectorXd &one : runs.evaluate(places, RunKind::packings))
    if (one.size() > 0)
      members.residuals.push_back(std::move(one));
  return members;
}

// How far residuals move the place of the least sum of squares. Where they
// say nothing, it stays.
VectorXd
step_of(const MatrixXd &jacobian, const VectorXd &residuals, double variance)
{
  const auto n = jacobian.cols();
  const MatrixXd normal = jacobian.transpose() * jacobian +
                          worth_noise * variance * MatrixXd::Identity(n, n);
  return -normal.ldlt().solve(jacobian.transpose() * residuals);
}
} // namespace

PackingFit fit_mean_of_packings(CalibrationRuns &runs,
                                const SearchSample &best,
                                const MatrixXd &jacobian,
                                unsigned packings)
{
  Members members = members_at(runs, best.place, 1, packings);
  members.residuals.insert(members.residuals.begin(), best.residuals);
  PackingFit fit{{best.place, members.mean()}, {}};
  const double variance =
      best.cost() / static_cast<double>(best.residuals.size());
  const VectorXd step = step_of(jacobian, fit.best.residuals, variance)
                            .cwiseMax(-longest_step)
                            .cwiseMin(longest_step);
  const VectorXd moved = (best.place + step).cwiseMax(0.0).cwiseMin(1.0);
  if (Members there = members_at(runs, moved, 0, packings);
      there.residuals.size() >= members.residuals.size() &&
      there.mean().squaredNorm() < fit.best.cost()) {
    members = std::move(there);
    fit.best = {moved, members.mean()};
  }
  const auto count = static_cast<double>(members.residuals.size());
  fit.scatter.packings = static_cast<unsigned>(members.residuals.size());
  if (fit.scatter.packings < 2)
    return fit;
  fit.scatter.covariance = MatrixXd::Zero(jacobian.cols(), jacobian.cols());
  for (const VectorXd &one : members.residuals) {
    const VectorXd apart =
        step_of(jacobian, one - fit.best.residuals, variance);
    fit.scatter.covariance += apart * apart.transpose() / (count - 1);
  }
  return fit;
}
} // namespace tamp::apps
