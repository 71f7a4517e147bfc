// SPDX-License-Identifier: BSD-3-Clause
#include <fem/density_range.h>
#include <fem/die_model.h>
#include <fem/equilibrium.h>
#include <fem/field_output.h>
#include <fem/press.h>
#include <fem/punch_area.h>
#include <fem/schedule.h>
#include <fem/stop_watch.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
/// A point's deformation in one step stays below this multiple of the largest
/// step.
constexpr double largest_concentration = 10;
/// A compact that is let go has corners that bear little: points under less
/// than this share of the largest mean pressure of the punch.
constexpr double bearing_share = 0.05;
} // namespace

struct DieModel::Implementation {
  DieSettings settings;
  const Mesh &mesh;
  StageBegins stage_begins;
  Press press;
  Equilibrium equilibrium;
  double area;                   ///< of the upper punch [m2]
  double upper_edge, lower_edge; ///< of the powder in the filled die, z [m]
  Schedule schedule;
  StepRecord record;
  Failure failure;
  PressState state;
  Increment last_increment; ///< of the phase; empty: none yet
  double last_driving = 0;
  unsigned last_phase = 0;
  /// Of all points as they began to leave the die; empty: they do not.
  std::vector<double> densities_inside;
  double seconds = 0;

  Implementation(const DieSettings &chosen,
                 const Mesh &data,
                 MaterialPoints &points,
                 StageBegins begins,
                 const Ranks &ranks,
                 std::span<const char> stored)
      : settings(chosen), mesh(data), stage_begins(std::move(begins)),
        press(data,
              {make_tools(chosen.geometry, data), chosen.friction},
              points,
              chosen.solver,
              ranks),
        equilibrium(
            press, chosen.solver, largest_concentration * chosen.steps.maximum),
        area(punch_area(data, upper_punch)),
        upper_edge(edge_height(data, upper_punch, data.nodes)),
        lower_edge(edge_height(data, lower_punch, data.nodes)), schedule(chosen)
  {
    if (stored.empty()) {
      observe();
      chosen.check_start(state.mean_density);
    } else {
      unpack(StateBytes(stored));
    }
  }

  template <class Self, class Use>
  static void each_part(Self &self, const Use &use)
  {
    use(self.record);
    use(self.state);
    use(self.last_increment);
    use(self.last_driving);
    use(self.last_phase);
    use(self.densities_inside);
    use(self.seconds);
  }

  void pack(std::vector<char> &bytes) const
  {
    press.pack(bytes);
    schedule.pack(bytes);
    each_part(*this, [&](const auto &part) { append_state(bytes, part); });
  }

  void unpack(StateBytes bytes)
  {
    press.unpack(bytes);
    schedule.unpack(bytes);
    each_part(*this, [&](auto &part) { bytes.take(part); });
    if (!bytes.empty())
      throw std::runtime_error("the stored state is that of another model");
  }

  /// How far the compact's lower edge is below that of its punch, and a little
  /// more: as it springs back it slides down a domed face [m].
  double lag(const NodePositions &positions) const
  {
    constexpr double surely = 1e-5; // of the compact's height
    double lowest = state.bottom;
    for (const Tool bore : {die_wall, core_rod}) {
      const auto &nodes = mesh.tools[bore].nodes;
      for (const unsigned node : mesh.tools[lower_punch].nodes)
        if (std::binary_search(nodes.begin(), nodes.end(), node))
          lowest = std::min(lowest, positions[node][2]);
    }
    return state.bottom - lowest + surely * state.height;
  }

  ForceOnTools on_tools(const ToolForces &forces) const
  {
    ForceOnTools result{};
    for (unsigned tool = 0; tool < number_of_tools; ++tool)
      result[tool] = -mesh.multiplicity() * forces[tool].force[2];
    return result;
  }

  /// Reads the accepted state into the record and the schedule's view.
  void observe()
  {
    const ToolForces &forces = press.forces();
    const double whole = mesh.multiplicity();
    const DensityRange density = density_range(press.compact());
    const Extent now = extent(press.compact().state().positions);
    const auto &positions = press.compact().state().positions;
    state.top = edge_height(mesh, upper_punch, positions);
    state.bottom = lower_edge + press.tools()[lower_punch];
    state.rim = upper_edge + press.tools()[die_wall];
    state.fill_height = upper_edge - lower_edge;
    state.height = state.fill_height + press.tools()[upper_punch] -
                   press.tools()[lower_punch];
    state.die_displacement = press.tools()[die_wall];
    state.element_height = press.contact().element_height();
    state.fading_height = press.contact().fading_height() + lag(positions);
    state.upper_displacement = -press.tools()[upper_punch];
    state.lower_displacement = press.tools()[lower_punch];
    state.force = on_tools(forces);
    state.peak_force =
        std::max(state.peak_force, schedule.pressing_force(state.force));
    state.mean_density = density.mean;
    record.upper_displacement = state.upper_displacement;
    record.lower_displacement = state.lower_displacement;
    record.die_displacement = state.die_displacement;
    record.upper_force = state.force[upper_punch];
    record.lower_force = whole * forces[lower_punch].force[2];
    record.wall_friction_force =
        whole * (forces[die_wall].force[2] + forces[core_rod].force[2]);
    record.wall_normal_force = whole * forces[die_wall].normal;
    record.wall_area = whole * forces[die_wall].area;
    record.punch_area = area;
    record.compact_height = mean_height(mesh, upper_punch, positions) -
                            mean_height(mesh, lower_punch, positions);
    record.compact_radius = now.radius;
    record.mean_relative_density = density.mean;
    record.minimum_relative_density = density.minimum;
    record.maximum_relative_density = density.maximum;
    record.work = press.work();
  }

  /// First guess of the increment: the last one of the phase, scaled; a uniform
  /// strain if there is none.
  Increment guess(const Proposal &proposal) const
  {
    Increment increment(number_of_unknowns(mesh), 0.);
    if (!last_increment.empty() && last_phase == schedule.phase() &&
        last_driving > 0) {
      const double scale = proposal.driving / last_driving;
      for (std::size_t i = 0; i < increment.size(); ++i)
        increment[i] = scale * last_increment[i];
      return increment;
    }
    const auto &positions = press.compact().state().positions;
    const Extent now = extent(positions);
    for (std::size_t node = 0; node < positions.size(); ++node) {
      const double share = (positions[node][2] - now.low) / (now.height());
      increment[mesh.axial_dof(node)] =
          (1 - share) * proposal.motion[lower_punch].displacement +
          share * proposal.motion[upper_punch].displacement;
    }
    return increment;
  }

  void remember_failure(const Attempt &attempt)
  {
    const Compact &compact = press.compact();
    failure.kind =
        attempt.opened ? FailureKind::opened : FailureKind::not_converged;
    failure.reason = "the step fell below its minimum: " + attempt.reason;
    failure.point = attempt.point;
    std::vector<double> values(9, 0.);
    if (compact.point_share().holds(attempt.point)) {
      const std::size_t local = attempt.point - compact.point_share().begin;
      for (unsigned i = 0; i < 3; ++i)
        values[i] = compact.geometry()[local].position[i];
      for (unsigned i = 0; i < 6; ++i)
        values[3 + i] =
            compact.state().responses[local].stress.access_raw_entry(i);
    }
    compact.ranks().sum(values);
    for (unsigned i = 0; i < 3; ++i)
      failure.position[i] = values[i];
    for (unsigned i = 0; i < 6; ++i)
      failure.stress.access_raw_entry(i) = values[3 + i];
  }

  void guard(const Proposal &proposal, Attempt &attempt) const
  {
    if (!settings.solver.guard_against_opening || !attempt.converged)
      return;
    equilibrium.refuse_opening(
        {schedule.kept_pressure(proposal, state, on_tools(attempt.forces)),
         schedule.presses() ? attempt.loose_pressure
                            : bearing_share * state.peak_force / area,
         schedule.presses() || schedule.ejects()
             ? 0
             : proposal.driving / state.height,
         densities_inside},
        attempt);
  }

  /// Tries a proposal, shorter and shorter if need be. False if the step gets
  /// too small.
  bool find_equilibrium(Proposal &proposal, Attempt &attempt, unsigned &cuts)
  {
    Attempt opened;
    while (true) {
      attempt = equilibrium.attempt(proposal.motion, guess(proposal));
      guard(proposal, attempt);
      updates += attempt.iterations;
      if (attempt.opened)
        opened = attempt;
      if (attempt.converged) {
        const auto loaded =
            schedule.instead(proposal, state, on_tools(attempt.forces));
        if (!loaded)
          return true;
        proposal = *loaded;
        continue;
      }
      const auto shorter = schedule.cut(proposal, state);
      if (!shorter) {
        remember_failure(opened.opened ? opened : attempt);
        return false;
      }
      ++cuts;
      proposal = *shorter;
    }
  }

  bool step(Proposal proposal)
  {
    if (!schedule.ejects())
      densities_inside.clear();
    else if (densities_inside.empty())
      densities_inside = relative_densities(press.compact());
    const PressState before = state;
    Attempt attempt;
    unsigned cuts = 0;
    updates = 0;
    if (!find_equilibrium(proposal, attempt, cuts))
      return false;
    equilibrium.accept();
    observe();
    schedule.accept(proposal, before, state, cuts > 0);
    remember_increment(proposal);
    ++record.step;
    record.stage = schedule.stage();
    record.iterations = attempt.iterations;
    record.material_updates = updates;
    record.cuts = cuts;
    record.force_residual = attempt.force_residual;
    record.displacement_change = attempt.displacement_change;
    record.stagnated = attempt.stagnated;
    record.doubtful_points = attempt.doubtful_points;
    record.stage_progress = schedule.progress(state);
    return true;
  }

  void remember_increment(const Proposal &proposal)
  {
    last_increment = equilibrium.increment();
    last_phase = schedule.phase();
    // The motion of a loaded punch was only a guess.
    const bool upper_drives = proposal.motion[lower_punch].displacement <= 0;
    last_driving = upper_drives
                       ? std::abs(last_increment[tool_dof(mesh, upper_punch)])
                       : proposal.driving;
  }

  Advance advance()
  {
    while (!schedule.finished()) {
      if (schedule.at_stage_begin()) {
        schedule.begin_stage(state);
        if (stage_begins)
          stage_begins(schedule.stage(), state.peak_force / area);
      }
      if (const auto reason = schedule.impossible(state)) {
        remember_failure({});
        failure.reason = *reason;
        failure.kind = FailureKind::impossible;
        return Advance::failed;
      }
      if (const auto proposal = schedule.propose(state))
        return step(*proposal) ? Advance::stepped : Advance::failed;
    }
    return Advance::finished;
  }

  unsigned updates = 0; ///< evaluations of all points in the current step
};

DieModel::DieModel(const DieSettings &settings,
                   const Mesh &mesh,
                   MaterialPoints &points,
                   StageBegins stage_begins,
                   const Ranks &ranks,
                   std::span<const char> state)
{
  settings.check();
  implementation_ = std::make_unique<Implementation>(
      settings, mesh, points, std::move(stage_begins), ranks, state);
}

DieModel::~DieModel() = default;

Advance DieModel::advance()
{
  const StopWatch watch(implementation_->seconds);
  return implementation_->advance();
}

void DieModel::pack(std::vector<char> &bytes) const
{
  implementation_->pack(bytes);
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
  const PressTimes &part = implementation_->press.times();
  return {part.material,
          part.assembly,
          part.contact,
          part.linear_solver,
          implementation_->seconds};
}

const std::vector<Response> &DieModel::responses() const
{
  return implementation_->press.compact().state().responses;
}

std::vector<dealii::Tensor<1, 3>> DieModel::point_positions() const
{
  std::vector<dealii::Tensor<1, 3>> positions;
  for (const PointGeometry &point : implementation_->press.compact().geometry())
    positions.push_back(point.position);
  return positions;
}

const std::vector<dealii::Tensor<2, 3>> &DieModel::deformation_gradients() const
{
  return implementation_->press.compact().state().deformation_gradients;
}

std::vector<double>
DieModel::whole(const std::vector<double> &of_this_rank) const
{
  return implementation_->press.compact().whole(of_this_rank);
}

void DieModel::write_fields(const std::filesystem::path &folder,
                            const std::string &name,
                            const std::vector<PointField> &extra) const
{
  write_compact(folder / (name + ".vtu"), implementation_->press, extra);
}
} // namespace tamp::fem
