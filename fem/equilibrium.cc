// SPDX-License-Identifier: BSD-3-Clause
#include <fem/anderson.h>
#include <fem/dot.h>
#include <fem/equilibrium.h>
#include <fem/newton.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace tamp::fem
{
namespace
{
/// Displacements are measured against at least this share of the height, that
/// of a usual step: with a material that is not exact a small step, of which
/// its noise is a larger part, would else converge worse than a large one.
constexpr double smallest_displacement = 5e-3;
/// Updates without progress after which an attempt is given up, and those after
/// which the nearest state is taken if it is within `slack` tolerances.
constexpr unsigned patience = 6, short_patience = 4;
constexpr double slack = 10;

double largest(const std::vector<double> &values)
{
  double result = 0;
  for (const double value : values)
    result = std::max(result, std::abs(value));
  return result;
}

double norm(const std::vector<double> &values)
{
  return std::sqrt(dot(values, values));
}

/// Watches the residual of an attempt for progress.
class Progress
{
public:
  /// @param share  of the best residual so far that counts as progress.
  explicit Progress(double share = 1) : share_(share) {}

  unsigned waited() const { return waited_; }

  bool stagnates(double residual)
  {
    if (residual < share_ * best_) {
      best_ = residual;
      waited_ = 0;
      return false;
    }
    return ++waited_ >= patience;
  }

private:
  double share_;
  double best_ = std::numeric_limits<double>::infinity();
  unsigned waited_ = 0;
};

std::string not_converged(const char *why, const Attempt &attempt)
{
  std::ostringstream text;
  text << why << " after " << attempt.iterations
       << " iterations: force residual " << attempt.force_residual
       << ", displacement change " << attempt.displacement_change;
  return text.str();
}
} // namespace

Equilibrium::Equilibrium(Press &press,
                         const SolverSettings &settings,
                         double largest_increment)
    : press_(press), settings_(settings), largest_increment_(largest_increment),
      height_(extent(press.mesh().nodes).height()),
      increment_(number_of_unknowns(press.mesh()), 0.)
{
}

bool Equilibrium::fails(const Fault &fault, Attempt &attempt) const
{
  ++attempt.iterations;
  if (fault.reason.empty())
    return false;
  attempt.reason = fault.reason;
  attempt.point = fault.point;
  return true;
}

std::vector<double> Equilibrium::measure(Attempt &attempt) const
{
  attempt.doubtful_points = press_.compact().doubtful_points();
  attempt.forces = press_.trial_forces();
  auto imbalance = press_.imbalance();
  attempt.force_residual = std::max(norm(imbalance) / press_.reference_force(),
                                    press_.tool_imbalance());
  return imbalance;
}

double Equilibrium::relative_change(const std::vector<double> &change) const
{
  return largest(change) /
         std::max(largest(increment_), smallest_displacement * height_);
}

bool Equilibrium::good(const Attempt &attempt, double tolerances) const
{
  return attempt.force_residual <= tolerances * settings_.force_tolerance &&
         attempt.displacement_change <= settings_.displacement_tolerance;
}

Attempt Equilibrium::attempt(const Motion &motion, const Increment &guess)
{
  Attempt attempt;
  increment_ = guess;
  if (fails(press_.begin(motion, increment_), attempt))
    return attempt;
  if (settings_.guard_against_opening)
    attempt.loose_pressure = loose_pressure();
  press_.take_reactions();
  if (settings_.method == NonlinearMethod::newton)
    search_newton(attempt);
  else
    search_accelerated(attempt);
  return attempt;
}

void Equilibrium::search_newton(Attempt &attempt)
{
  std::vector<double> imbalance;
  Progress progress(0.5);
  bool fresh = true; // begin() has made the first trial
  NewtonProblem problem;
  problem.residual = [&](const std::vector<double> &x, std::vector<double> &r) {
    if (!fresh) {
      if (fails(press_.move(x, Want::stress_and_tangent), attempt))
        return false;
      press_.assemble_stiffness();
      press_.take_reactions();
    }
    fresh = false;
    increment_ = x;
    r = imbalance = measure(attempt);
    return !progress.stagnates(attempt.force_residual);
  };
  problem.solve = [&](std::span<const double>, std::span<double> y) {
    // SNES subtracts its solution.
    const auto change = press_.balance_tools(increment_);
    for (std::size_t i = 0; i < change.size(); ++i)
      y[i] = -change[i];
    return !change.empty();
  };
  problem.limit = [&](const Increment &x, Increment &step) {
    // A kink of law or contact can make full steps go round in circles.
    if (progress.waited() > 1)
      for (double &value : step)
        value *= 0.5;
    Increment to = x;
    for (std::size_t i = 0; i < to.size(); ++i)
      to[i] += step[i];
    shorten(x, to);
    for (std::size_t i = 0; i < to.size(); ++i)
      step[i] = to[i] - x[i];
  };
  problem.converged = [&](const Increment &, const Increment &step) {
    attempt.displacement_change = relative_change(step);
    if (step.empty()) // a guess that needs no correction is balanced well
      return attempt.force_residual <= 1e-2 * settings_.force_tolerance;
    return good(attempt);
  };
  const NewtonOutcome outcome =
      solve_newton(problem, increment_, settings_.maximum_iterations);
  attempt.converged = outcome.converged;
  if (!outcome.converged && attempt.reason.empty()) {
    attempt.point = point_of_largest(imbalance);
    attempt.reason = not_converged(outcome.reason.c_str(), attempt);
  }
}

std::vector<double> Equilibrium::judge(Attempt &attempt)
{
  attempt.point = point_of_largest(measure(attempt));
  auto change = press_.balance_tools(increment_);
  if (change.empty())
    attempt.reason = "the tools cannot be balanced with the tangent";
  else
    attempt.displacement_change = relative_change(change);
  return change;
}

void Equilibrium::search_accelerated(Attempt &attempt)
{
  Progress progress(0.9);
  Anderson anderson(settings_.anderson_depth);
  Increment nearest; // empty: none is near enough
  double least = std::numeric_limits<double>::infinity();
  for (bool first = true;; first = false) {
    if (!first) {
      if (fails(press_.move(increment_, Want::stress), attempt))
        return;
      press_.take_reactions();
    }
    const auto change = judge(attempt);
    if (change.empty())
      return;
    if (good(attempt)) {
      attempt.converged = true;
      return;
    }
    if (good(attempt, slack) && attempt.force_residual < least) {
      least = attempt.force_residual;
      nearest = increment_;
    }
    const bool stagnates = progress.stagnates(attempt.force_residual);
    const bool too_long = attempt.iterations >= settings_.maximum_iterations;
    if (!nearest.empty() && (too_long || progress.waited() >= short_patience))
      return settle_for(nearest, attempt);
    if (stagnates || too_long) {
      attempt.reason =
          not_converged(stagnates ? "no progress" : "no equilibrium", attempt);
      return;
    }
    Increment next = anderson.next(increment_, change);
    shorten(increment_, next);
    increment_ = next;
  }
}

void Equilibrium::settle_for(const Increment &nearest, Attempt &attempt)
{
  increment_ = nearest;
  if (fails(press_.move(increment_, Want::stress), attempt))
    return;
  press_.take_reactions();
  if (judge(attempt).empty())
    return;
  const double lost = std::abs(dot(press_.imbalance(), increment_));
  const double work = std::abs(press_.work_of_powder(increment_));
  attempt.stagnated = attempt.converged =
      good(attempt, slack) && lost <= slack * settings_.force_tolerance * work;
  if (!attempt.converged)
    attempt.reason = not_converged("no progress", attempt);
}

double Equilibrium::loose_pressure() const
{
  // Grains of alumina at 0.5 MPa: from 0.1 MPa on, cells of 100 of them give
  // way now and then below. What yields is as soft, and as loose, at its own.
  constexpr double loose_share = 0.04;
  std::vector<double> sums{0, 0}; // bulk moduli, points
  for (const Response &response : press_.compact().trial_responses()) {
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = 0; j < 3; ++j)
        sums[0] += response.tangent[i][i][j][j] / 9;
    ++sums[1];
  }
  press_.ranks().sum(sums);
  return loose_share * sums[0] / sums[1];
}

void Equilibrium::refuse_opening(const OpeningLimits &limits,
                                 Attempt &attempt) const
{
  const auto opening = find_opening(press_.compact(), limits);
  if (!opening)
    return;
  attempt.converged = false;
  attempt.opened = true;
  attempt.point = opening->point;
  attempt.reason = "a material point opens: it " + opening->reason;
}

void Equilibrium::shorten(const Increment &from, Increment &to) const
{
  const double strain = press_.compact().largest_strain(to);
  if (!(strain > largest_increment_))
    return;
  const double length = 0.5 * largest_increment_ / strain;
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] = from[i] + length * (to[i] - from[i]);
}

std::size_t
Equilibrium::point_of_largest(const std::vector<double> &imbalance) const
{
  const Mesh &mesh = press_.mesh();
  std::size_t worst = 0;
  for (std::size_t dof = 0; dof < mesh.number_of_dofs(); ++dof)
    if (std::abs(imbalance[dof]) > std::abs(imbalance[worst]))
      worst = dof;
  const auto node = static_cast<unsigned>(worst / mesh.components());
  // The point nearest to a cell's node has the node's number in the cell.
  const auto place = std::find(mesh.cells.begin(), mesh.cells.end(), node);
  return static_cast<std::size_t>(place - mesh.cells.begin());
}
} // namespace tamp::fem
