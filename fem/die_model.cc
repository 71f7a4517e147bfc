// SPDX-License-Identifier: BSD-3-Clause
#include <fem/die_mesh_data.h>
#include <fem/die_model.h>
#include <fem/equilibrium.h>
#include <fem/field_output.h>
#include <fem/schedule.h>
#include <fem/stop_watch.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
/// A point's deformation in one step stays below this multiple of the largest
/// step.
constexpr double largest_concentration = 10;

ForceOnTools on_tools(const ToolForces &forces)
{
  ForceOnTools result{};
  result[upper_punch] = forces.upper;
  result[lower_punch] = -forces.lower;
  return result;
}

PunchMotion punch_motion(const Motion &motion)
{
  const ToolMotion &upper = motion[upper_punch], &lower = motion[lower_punch];
  const ToolMotion &die = motion[die_wall];
  if (lower.loaded || die.loaded || die.displacement != 0)
    throw std::invalid_argument("a stage moves the die or loads the lower "
                                "punch; expected one that does not");
  return {upper.loaded, upper.displacement, upper.force, lower.displacement};
}

struct Densities {
  double mean = 0, minimum = 0, maximum = 0;
};

Densities densities(const DieMesh::Data &mesh, const CompactState &state)
{
  Densities result;
  result.minimum = result.maximum = state.responses.front().relative_density;
  double mass = 0, volume = 0;
  for (std::size_t point = 0; point < state.responses.size(); ++point) {
    const double density = state.responses[point].relative_density;
    const double part = point_geometry(mesh, state.positions, point).volume;
    mass += density * part;
    volume += part;
    result.minimum = std::min(result.minimum, density);
    result.maximum = std::max(result.maximum, density);
  }
  result.mean = mass / volume;
  return result;
}
} // namespace

struct DieModel::Implementation {
  DieSettings settings;
  const DieMesh::Data &mesh;
  StageBegins stage_begins;
  Equilibrium equilibrium;
  Schedule schedule;
  StepRecord record;
  Failure failure;
  PressState press;
  Displacement last_increment; ///< of the phase; empty: none yet
  double last_driving = 0;
  unsigned last_phase = 0;
  double seconds = 0;

  Implementation(const DieSettings &chosen,
                 const DieMesh::Data &data,
                 MaterialPoints &points,
                 StageBegins begins)
      : settings(chosen), mesh(data), stage_begins(std::move(begins)),
        equilibrium(data,
                    points,
                    chosen.wall_friction_coefficient,
                    chosen.solver,
                    largest_concentration * chosen.steps.maximum),
        schedule(chosen)
  {
    observe();
    chosen.check_start(press.mean_density);
  }

  double punch_area() const
  {
    return std::numbers::pi * mesh.radius * mesh.radius;
  }

  /// Reads the accepted state into the record and the schedule's view.
  void observe()
  {
    const CompactState &state = equilibrium.state();
    const double top = state.positions[mesh.punch_top.front()][1];
    const double bottom = state.positions[mesh.punch_bottom.front()][1];
    const Densities density = densities(mesh, state);
    press.top = top;
    press.bottom = bottom;
    press.rim = mesh.top;
    press.height = top - bottom;
    press.fill_height = mesh.top - mesh.bottom;
    press.element_height =
        press.height / static_cast<double>(mesh.wall.size() - 1);
    press.upper_displacement = mesh.top - top;
    press.lower_displacement = bottom - mesh.bottom;
    press.force = on_tools(state.forces);
    press.peak_force =
        std::max(press.peak_force, schedule.pressing_force(press.force));
    press.mean_density = density.mean;
    record.upper_displacement = press.upper_displacement;
    record.lower_displacement = press.lower_displacement;
    record.upper_force = state.forces.upper;
    record.lower_force = state.forces.lower;
    record.wall_friction_force = state.forces.wall_friction;
    record.wall_normal_force = state.forces.wall_normal;
    record.wall_area = 2 * std::numbers::pi * mesh.radius * press.height;
    record.punch_area = punch_area();
    record.mean_relative_density = density.mean;
    record.minimum_relative_density = density.minimum;
    record.maximum_relative_density = density.maximum;
  }

  /// First guess of the increment: the last one of the phase, scaled; a uniform
  /// strain if there is none.
  Displacement guess(const Proposal &proposal) const
  {
    Displacement increment(mesh.number_of_dofs(), 0.);
    if (!last_increment.empty() && last_phase == schedule.phase() &&
        last_driving > 0) {
      const double scale = proposal.driving / last_driving;
      for (std::size_t dof = 0; dof < increment.size(); ++dof)
        increment[dof] = scale * last_increment[dof];
      return increment;
    }
    const auto &positions = equilibrium.state().positions;
    const double bottom = press.top - press.height;
    for (std::size_t node = 0; node < positions.size(); ++node) {
      const double share = (positions[node][1] - bottom) / press.height;
      increment[2 * node + 1] =
          (1 - share) * proposal.motion[lower_punch].displacement +
          share * proposal.motion[upper_punch].displacement;
    }
    return increment;
  }

  void remember_failure(const Attempt &attempt, const std::string &reason)
  {
    const CompactState &state = equilibrium.state();
    failure.reason = reason;
    failure.point = attempt.point;
    failure.position =
        point_geometry(mesh, state.positions, attempt.point).position;
    failure.stress = state.responses[attempt.point].stress;
  }

  /// Tries a proposal, shorter and shorter if need be. False if the step gets
  /// too small.
  bool find_equilibrium(Proposal &proposal, Attempt &attempt, unsigned &cuts)
  {
    const bool guard =
        settings.solver.guard_against_opening && schedule.presses();
    while (true) {
      attempt = equilibrium.attempt(
          punch_motion(proposal.motion), guess(proposal), guard);
      if (attempt.converged) {
        const auto loaded =
            schedule.instead(proposal, press, on_tools(attempt.forces));
        if (!loaded)
          return true;
        proposal = *loaded;
        continue;
      }
      const auto shorter = schedule.cut(proposal, press);
      if (!shorter) {
        remember_failure(attempt,
                         "the step fell below its minimum: " + attempt.reason);
        return false;
      }
      ++cuts;
      proposal = *shorter;
    }
  }

  bool step(Proposal proposal)
  {
    const unsigned evaluations = equilibrium.evaluations();
    const PressState before = press;
    Attempt attempt;
    unsigned cuts = 0;
    if (!find_equilibrium(proposal, attempt, cuts))
      return false;
    equilibrium.accept();
    observe();
    schedule.accept(proposal, before, press, cuts > 0);
    remember_increment(proposal);
    ++record.step;
    record.stage = schedule.stage();
    record.iterations = attempt.iterations;
    record.material_updates = equilibrium.evaluations() - evaluations;
    record.cuts = cuts;
    record.force_residual = attempt.force_residual;
    record.displacement_change = attempt.displacement_change;
    record.doubtful_points = attempt.doubtful_points;
    record.stage_progress = schedule.progress(press);
    return true;
  }

  void remember_increment(const Proposal &proposal)
  {
    last_increment = equilibrium.increment();
    last_phase = schedule.phase();
    // The motion of a loaded punch was only a guess.
    const bool upper_drives = proposal.motion[lower_punch].displacement <= 0;
    last_driving =
        upper_drives ? std::abs(last_increment[2 * mesh.punch_top.front() + 1])
                     : proposal.driving;
  }

  Advance advance()
  {
    while (!schedule.finished()) {
      if (schedule.at_stage_begin()) {
        schedule.begin_stage(press);
        if (stage_begins)
          stage_begins(schedule.stage(), press.peak_force / punch_area());
      }
      if (const auto reason = schedule.impossible(press)) {
        remember_failure({}, *reason);
        return Advance::failed;
      }
      if (const auto proposal = schedule.propose(press))
        return step(*proposal) ? Advance::stepped : Advance::failed;
    }
    return Advance::finished;
  }
};

DieModel::DieModel(const DieSettings &settings,
                   const DieMesh &mesh,
                   MaterialPoints &points,
                   StageBegins stage_begins)
{
  settings.check();
  implementation_ = std::make_unique<Implementation>(
      settings, mesh.data(), points, std::move(stage_begins));
}

DieModel::~DieModel() = default;

Advance DieModel::advance()
{
  const StopWatch watch(implementation_->seconds);
  return implementation_->advance();
}

const StepRecord &DieModel::last_step() const
{
  return implementation_->record;
}

const Failure &DieModel::failure() const
{
  return implementation_->failure;
}

ModelTimes DieModel::times() const
{
  const SolverTimes &part = implementation_->equilibrium.times();
  return {part.material,
          part.assembly,
          part.linear_solver,
          implementation_->seconds};
}

const std::vector<Response> &DieModel::responses() const
{
  return implementation_->equilibrium.state().responses;
}

std::vector<dealii::Tensor<1, 2>> DieModel::point_positions() const
{
  const auto &mesh = implementation_->mesh;
  std::vector<dealii::Tensor<1, 2>> positions;
  for (std::size_t point = 0; point < mesh.number_of_points(); ++point)
    positions.push_back(
        point_geometry(
            mesh, implementation_->equilibrium.state().positions, point)
            .position);
  return positions;
}

const std::vector<dealii::Tensor<2, 3>> &DieModel::deformation_gradients() const
{
  return implementation_->equilibrium.state().deformation_gradients;
}

void DieModel::write_fields(const std::filesystem::path &folder,
                            const std::string &name,
                            const std::vector<PointField> &extra) const
{
  write_compact(folder / (name + ".vtu"),
                implementation_->mesh,
                implementation_->equilibrium.state(),
                extra);
}
} // namespace tamp::fem
