// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_newton_h
#define fem_newton_h

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace tamp::fem
{
/// A system of nonlinear equations r(x) = 0 as Newton's method sees it.
struct NewtonProblem {
  /// r at x; false if x is out of the question.
  std::function<bool(const std::vector<double> &x, std::vector<double> &r)>
      residual;
  /// The solution of J y = r with the derivative J at the x of the last
  /// residual(); false if there is none.
  std::function<bool(std::span<const double> r, std::span<double> y)> solve;
  /// Shortens a step from x, if it goes too far; x + step is tried next.
  std::function<void(const std::vector<double> &x, std::vector<double> &step)>
      limit;
  /// Is the x of the last residual() good enough? @param step  that led there;
  /// empty at the start.
  std::function<bool(const std::vector<double> &x,
                     const std::vector<double> &step)>
      converged;
};

struct NewtonOutcome {
  bool converged = false;
  std::string reason; ///< why not
  unsigned iterations = 0;
};

/// Newton's method with PETSc's SNES (full steps; the linear equations are the
/// problem's own affair), from x on, which ends as the last iterate. Exceptions
/// of the problem pass through.
NewtonOutcome solve_newton(const NewtonProblem &problem,
                           std::vector<double> &x,
                           unsigned maximum_iterations);
} // namespace tamp::fem

#endif
