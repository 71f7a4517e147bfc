// SPDX-License-Identifier: BSD-3-Clause
#include <fem/anderson.h>
#include <fem/assembler.h>
#include <fem/equilibrium.h>
#include <fem/stop_watch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
/// Residuals are measured against at least this share of the largest reactions
/// so far: at zero force there is nothing else to compare with.
constexpr double smallest_reaction = 1e-4;
/// Displacements are measured against at least this share of the height, that
/// of a usual step: with a material that is not exact a small step, of which
/// its noise is a larger part, would else converge worse than a large one.
constexpr double smallest_displacement = 5e-3;
/// Updates without a new best residual after which an attempt is given up.
constexpr unsigned patience = 6;

double largest(const std::vector<double> &values)
{
  double result = 0;
  for (const double value : values)
    result = std::max(result, std::abs(value));
  return result;
}

double norm(const std::vector<double> &values)
{
  return std::sqrt(
      std::inner_product(values.begin(), values.end(), values.begin(), 0.));
}

bool usable(const Response &response, Want want)
{
  bool finite = std::isfinite(response.stress.norm()) &&
                std::isfinite(response.relative_density);
  if (want == Want::stress_and_tangent)
    finite = finite && std::isfinite(response.tangent.norm());
  return finite && response.status != Status::failed;
}

double pressure(const Response &response)
{
  return -dealii::trace(response.stress) / 3;
}

dealii::Tensor<2, 3> unit_tensor()
{
  dealii::Tensor<2, 3> unit;
  unit[0][0] = unit[1][1] = unit[2][2] = 1;
  return unit;
}

/// Watches the residual of an attempt for progress.
class Progress
{
public:
  bool stagnates(double residual)
  {
    if (residual < best_) {
      best_ = residual;
      waited_ = 0;
      return false;
    }
    return ++waited_ >= patience;
  }

private:
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

Equilibrium::Equilibrium(const DieMesh::Data &mesh,
                         MaterialPoints &points,
                         double wall_friction_coefficient,
                         const SolverSettings &settings,
                         double largest_increment)
    : mesh_(mesh), points_(points), settings_(settings),
      largest_increment_(largest_increment),
      contact_(mesh, wall_friction_coefficient),
      stiffness_(stiffness_pattern(mesh))
{
  if (points.size() != mesh.number_of_points())
    throw std::invalid_argument("the mesh has " +
                                std::to_string(mesh.number_of_points()) +
                                " material points, but " +
                                std::to_string(points.size()) + " were given");
  state_.positions = mesh.nodes;
  state_.deformation_gradients.assign(points.size(), unit_tensor());
  state_.wall_friction.assign(mesh.wall.size(), 0.);
  trial_.increment.assign(mesh.number_of_dofs(), 0.);
  trial_.responses.resize(points.size());
  Attempt start;
  if (!deform(start) || !evaluate(Want::stress, start))
    throw std::runtime_error("material point " + std::to_string(start.point) +
                             " has no state to start from: " + start.reason);
  state_.responses = trial_.responses;
  contact_.begin(stiffness_, PunchMotion(), state_.wall_friction);
  state_.forces =
      contact_.forces(internal_forces(mesh, state_.positions, state_.responses),
                      trial_.increment);
}

bool Equilibrium::deform(Attempt &attempt)
{
  trial_.positions = moved(state_.positions, trial_.increment);
  relative_deformations(
      mesh_, state_.positions, trial_.increment, trial_.deformations);
  for (std::size_t point = 0; point < trial_.deformations.size(); ++point) {
    const double volume = point_geometry(mesh_, trial_.positions, point).volume;
    if (!(volume > 0)) {
      attempt.point = point;
      attempt.reason = "an element turns inside out";
      return false;
    }
  }
  return true;
}

bool Equilibrium::evaluate(Want want, Attempt &attempt)
{
  const StopWatch watch(times_.material);
  ++evaluations_;
  points_.evaluate(trial_.deformations, want, trial_.responses);
  attempt.doubtful_points = 0;
  for (std::size_t point = 0; point < trial_.responses.size(); ++point) {
    const Response &response = trial_.responses[point];
    if (!usable(response, want)) {
      attempt.point = point;
      attempt.reason = response.status == Status::failed
                           ? "a material point failed"
                           : "a material point's answer is not finite";
      return false;
    }
    if (response.status == Status::doubtful)
      ++attempt.doubtful_points;
  }
  return true;
}

Attempt Equilibrium::attempt(const PunchMotion &motion,
                             const Displacement &guess,
                             bool guard)
{
  Attempt attempt;
  Progress progress;
  Anderson anderson(is_newton() ? 0 : settings_.anderson_depth);
  points_.begin_attempt();
  trial_.increment = guess;
  contact_.prescribe(motion, trial_.increment);

  while (update_forces(motion, attempt)) {
    const std::vector<double> change = balance_linearised(attempt);
    if (change.empty()) {
      attempt.reason = "the tools cannot be balanced with the tangent";
      return attempt;
    }
    if (attempt.force_residual <= settings_.force_tolerance &&
        attempt.displacement_change <= settings_.displacement_tolerance) {
      attempt.converged = !(guard && opens(attempt));
      return attempt;
    }
    if (progress.stagnates(attempt.force_residual)) {
      attempt.reason = not_converged("no progress", attempt);
      return attempt;
    }
    if (attempt.iterations >= settings_.maximum_iterations) {
      attempt.reason = not_converged("no equilibrium", attempt);
      return attempt;
    }
    Displacement next = anderson.next(trial_.increment, change);
    shorten(trial_.increment, next);
    trial_.increment = next;
  }
  return attempt;
}

bool Equilibrium::update_forces(const PunchMotion &motion, Attempt &attempt)
{
  const bool first = attempt.iterations == 0;
  const bool renew = first || is_newton();
  if (!deform(attempt))
    return false;
  ++attempt.iterations;
  if (!evaluate(renew ? Want::stress_and_tangent : Want::stress, attempt))
    return false;

  const StopWatch watch(times_.assembly);
  trial_.internal = internal_forces(mesh_, trial_.positions, trial_.responses);
  if (renew)
    assemble_stiffness(mesh_, trial_.positions, trial_.responses, stiffness_);
  if (first)
    contact_.begin(stiffness_, motion, state_.wall_friction);
  else if (renew)
    contact_.forget_factors();
  trial_.forces = contact_.forces(trial_.internal, trial_.increment);
  attempt.forces = trial_.forces;
  const auto imbalance = contact_.imbalance(trial_.internal, trial_.forces);
  attempt.force_residual =
      std::max(norm(imbalance) / reference_force(), tool_imbalance());
  attempt.point = point_of_largest(imbalance);
  return true;
}

std::vector<double> Equilibrium::balance_linearised(Attempt &attempt)
{
  const StopWatch watch(times_.linear_solver);
  const auto change = contact_.balance(
      stiffness_, trial_.internal, trial_.increment, reference_force());
  const double height = mesh_.top - mesh_.bottom;
  attempt.displacement_change =
      largest(change) /
      std::max(largest(trial_.increment), smallest_displacement * height);
  return change;
}

double Equilibrium::reference_force() const
{
  return std::max({trial_.forces.reactions,
                   smallest_reaction * peak_reactions_,
                   std::numeric_limits<double>::min()});
}

double Equilibrium::tool_imbalance() const
{
  const ToolForces &tools = trial_.forces;
  const double largest_force = std::max({std::abs(tools.upper),
                                         std::abs(tools.lower),
                                         std::abs(tools.wall_normal),
                                         smallest_reaction * peak_reactions_,
                                         std::numeric_limits<double>::min()});
  return std::abs(tools.upper - tools.lower - tools.wall_friction) /
         largest_force;
}

bool Equilibrium::opens(Attempt &attempt) const
{
  constexpr double kept_pressure = 0.3, largest_growth = 2e-3;
  for (std::size_t point = 0; point < trial_.responses.size(); ++point) {
    const double before = pressure(state_.responses[point]);
    const double now = pressure(trial_.responses[point]);
    const double volume =
        dealii::determinant(trial_.deformations[point].relative_F);
    if ((before > 0 && now < kept_pressure * before) ||
        volume > 1 + largest_growth) {
      attempt.point = point;
      attempt.reason = "a material point opens";
      return true;
    }
  }
  return false;
}

void Equilibrium::shorten(const Displacement &from, Displacement &to) const
{
  std::vector<Deformation> deformations;
  relative_deformations(mesh_, state_.positions, to, deformations);
  const double strain = largest_strain(deformations);
  if (!(strain > largest_increment_))
    return;
  const double length = 0.5 * largest_increment_ / strain;
  for (std::size_t dof = 0; dof < to.size(); ++dof)
    to[dof] = from[dof] + length * (to[dof] - from[dof]);
}

std::size_t
Equilibrium::point_of_largest(const std::vector<double> &imbalance) const
{
  std::size_t worst = 0;
  for (std::size_t dof = 0; dof < imbalance.size(); ++dof)
    if (std::abs(imbalance[dof]) > std::abs(imbalance[worst]))
      worst = dof;
  const auto &node = trial_.positions[worst / 2];
  std::size_t nearest = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t point = 0; point < mesh_.number_of_points(); ++point) {
    const double distance =
        (point_geometry(mesh_, trial_.positions, point).position - node).norm();
    if (distance < smallest) {
      smallest = distance;
      nearest = point;
    }
  }
  return nearest;
}

void Equilibrium::accept()
{
  points_.commit();
  state_.positions = trial_.positions;
  state_.responses = trial_.responses;
  state_.forces = trial_.forces;
  for (std::size_t i = 0; i < state_.wall_friction.size(); ++i)
    state_.wall_friction[i] = trial_.forces.wall[i].friction;
  for (std::size_t point = 0; point < trial_.deformations.size(); ++point)
    state_.deformation_gradients[point] =
        trial_.deformations[point].relative_F *
        state_.deformation_gradients[point];
  peak_reactions_ = std::max(peak_reactions_, trial_.forces.reactions);
}
} // namespace tamp::fem
