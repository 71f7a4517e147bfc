// SPDX-License-Identifier: BSD-3-Clause
#include <fem/schedule.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace tamp::fem
{
namespace
{
/// The first step against the direction of the last loading is this share of
/// the usual first one: friction reverses within it.
constexpr double gentle = 0.25;
/// A compact that slides up as a whole hardly strains: an ejection step may be
/// this multiple of the unloading one as long as the height keeps.
constexpr double sliding = 20;
/// Shares of the height, of a force: below, a target is met.
constexpr double met = 1e-9;
/// Powder of this relative density is solid: its force has no bound.
constexpr double solid = 0.999;
/// Punches do not come closer than this share of the fill height.
constexpr double least_height = 0.05;
/// Densities and forces that differ by these shares may both be meant.
constexpr double alike_densities = 1e-4, alike_forces = 1e-2;

bool has_force_target(const Stage &stage)
{
  return stage.target == StageTarget::force ||
         stage.target == StageTarget::peak_share;
}
} // namespace

Schedule::Schedule(const DieSettings &settings)
    : stages_(settings.stages), limits_(settings.steps),
      floating_die_(settings.floating_die)
{
  const auto first =
      std::find_if(stages_.begin(), stages_.end(), [](const Stage &stage) {
        return stage.kind == StageKind::press;
      });
  if (first != stages_.end())
    pressing_ = first->pressing;
}

bool Schedule::presses() const
{
  return !finished() &&
         (now().kind == StageKind::press || now().kind == StageKind::hold);
}

double Schedule::pressing_force(const ForceOnTools &force) const
{
  if (!finished() && now().kind == StageKind::eject)
    return 0;
  return pressing_ == Pressing::lower ? -force[lower_punch]
                                      : force[upper_punch];
}

double Schedule::force_of_mover(const ForceOnTools &force) const
{
  return movers_ == Pressing::lower ? -force[lower_punch] : force[upper_punch];
}

double Schedule::kept_pressure(const Proposal &proposal,
                               const PressState &before,
                               const ForceOnTools &after) const
{
  if (presses())
    return 1;
  if (phase_ == Phase::eject) {
    constexpr double surely = 1e-6; // of the height
    const double way = proposal.motion[lower_punch].displacement -
                       proposal.motion[die_wall].displacement;
    return before.top + way <= before.rim + surely * before.height ? 1 : 0;
  }
  const double was = force_of_mover(before.force);
  return was > 0 ? std::clamp(force_of_mover(after) / was, 0., 1.) : 0;
}

double Schedule::closing(const PressState &state) const
{
  return movers_ == Pressing::lower ? state.lower_displacement
                                    : state.upper_displacement;
}

unsigned Schedule::number_of_movers() const
{
  return movers_ == Pressing::both ? 2 : 1;
}

void Schedule::begin_stage(const PressState &state)
{
  const Stage &stage = now();
  if (stage.kind == StageKind::press)
    movers_ = pressing_ = stage.pressing;
  else if (stage.kind == StageKind::unload && pressing_ == Pressing::lower)
    movers_ = Pressing::lower;
  else
    movers_ = Pressing::upper;
  if (stage.kind == StageKind::eject)
    target_force_ = stage.hold_share * state.peak_force;
  else
    target_force_ = stage.target == StageTarget::peak_share
                        ? stage.value * state.peak_force
                        : stage.value;
  const double force = force_of_mover(state.force);
  if (stage.kind == StageKind::hold)
    begin_phase(Phase::hold, state);
  else if (stage.frees() ||
           (stage.kind == StageKind::eject && target_force_ <= 0))
    begin_phase(Phase::release, state);
  else if (stage.kind == StageKind::eject)
    begin_phase(std::abs(force - target_force_) <=
                        1e-6 * peak_or_force(state, target_force_)
                    ? Phase::eject
                    : Phase::to_force,
                state);
  else
    begin_phase(has_force_target(stage) ? Phase::to_force : Phase::to_distance,
                state);
}

void Schedule::begin_phase(Phase phase, const PressState &state)
{
  phase_ = phase;
  ++phase_count_;
  begin_ = before_ = after_ = state;
  landed_ = false;
  steps_done_ = 0;
  slope_ = volume_slope_ = last_driving_ = 0;
  direction_ = target_force_ >= force_of_mover(state.force) ? 1 : -1;
  first_remaining_ = phase == Phase::to_distance || phase == Phase::eject
                         ? remaining(state)
                         : 0;
  const bool loads = now().kind == StageKind::press ||
                     (phase == Phase::to_force && direction_ > 0);
  const double largest = loads ? limits_.maximum : limits_.unloading;
  step_ = StepControl(loads ? limits_.first
                            : gentle * std::min(limits_.first, largest),
                      phase == Phase::eject ? sliding * largest : largest,
                      limits_.growth);
}

double Schedule::remaining(const PressState &state) const
{
  const Stage &stage = now();
  if (stage.target == StageTarget::rim)
    return state.rim - state.top;
  if (stage.target == StageTarget::out)
    return state.rim + state.fading_height - state.bottom;
  if (stage.kind == StageKind::eject)
    return stage.value -
           (stage.ejection == Ejection::push
                ? state.lower_displacement - begin_.lower_displacement
                : begin_.die_displacement - state.die_displacement);
  if (stage.target == StageTarget::density) {
    // Volume falls with the height, in proportion only if the faces are flat.
    const double slope = volume_slope_ > 0
                             ? volume_slope_
                             : 1 / (state.mean_density * state.height);
    return (1 / state.mean_density - 1 / stage.value) / slope /
           number_of_movers();
  }
  return stage.value - std::abs(closing(state) - closing(begin_));
}

double Schedule::peak_or_force(const PressState &state, double force)
{
  return std::max(state.peak_force, std::abs(force));
}

bool Schedule::reached(const PressState &state) const
{
  const double force = force_of_mover(state.force);
  switch (phase_) {
  case Phase::none:
    return true;
  case Phase::to_distance:
    return remaining(state) <= (landed_ ? limits_.minimum : met) * state.height;
  case Phase::to_force:
    return landed_ || direction_ * (target_force_ - force) <=
                          met * peak_or_force(state, target_force_);
  case Phase::release:
    return force <= met * peak_or_force(state, force_of_mover(begin_.force));
  case Phase::eject:
    // The compact's upper edge need not move as far as the punch does.
    return remaining(state) <=
           (now().target == StageTarget::rim ? 1e-6 : met) * state.height;
  case Phase::hold:
    return steps_done_ >= now().steps;
  }
  return true;
}

std::optional<std::string> Schedule::impossible(const PressState &state) const
{
  if (finished() || phase_ == Phase::none)
    return {};
  const std::string problem = now().kind == StageKind::press
                                  ? cannot_press(state)
                                  : cannot_change_force(state);
  if (problem.empty())
    return {};
  std::ostringstream sentence;
  sentence << "stage " << stage_ + 1 << " cannot be done: " << problem;
  return sentence.str();
}

std::string Schedule::cannot_change_force(const PressState &state) const
{
  const double force = force_of_mover(state.force);
  const bool other_way = (now().kind == StageKind::press && direction_ < 0) ||
                         (now().kind == StageKind::unload && direction_ > 0);
  if (phase_ != Phase::to_force || steps_done_ > 0 || !other_way ||
      std::abs(target_force_ - force) <=
          alike_forces * peak_or_force(state, target_force_))
    return {};
  std::ostringstream problem;
  problem << "it asks for " << target_force_ << " N, but the punch bears "
          << (direction_ < 0 ? "" : "only ") << force << " N"
          << (direction_ < 0 ? " already" : "");
  return problem.str();
}

std::string Schedule::cannot_press(const PressState &state) const
{
  const Stage &stage = now();
  std::ostringstream problem;
  if (stage.target == StageTarget::density && steps_done_ == 0 &&
      state.mean_density > stage.value * (1 + alike_densities))
    problem << "it asks for a mean relative density of " << stage.value
            << ", but the compact has " << state.mean_density << " already";
  else if (reached(state))
    return {};
  else if (phase_ == Phase::to_force && state.mean_density > solid)
    problem << "the compact is solid, its mean relative density is "
            << state.mean_density << ", but the punch bears only "
            << force_of_mover(state.force) << " N of " << target_force_ << " N";
  else if (state.height < least_height * state.fill_height)
    problem << "less than " << 100 * least_height
            << " % of the fill height is left between the punches, "
            << state.height << " m, and the target is not met";
  else if (stage.target == StageTarget::displacement &&
           number_of_movers() * remaining(state) >= state.height)
    problem << "the upper punch would pass below the lower one: they are "
            << state.height << " m apart and are to come closer by "
            << number_of_movers() * remaining(state) << " m";
  else
    return cannot_change_force(state);
  return problem.str();
}

std::optional<Proposal> Schedule::propose(const PressState &state)
{
  if (now().kind == StageKind::eject && phase_ != Phase::eject &&
      reached(state))
    begin_phase(Phase::eject, state);
  if (reached(state)) {
    ++stage_;
    phase_ = Phase::none;
    return {};
  }
  switch (phase_) {
  case Phase::to_distance:
    return to_distance(state);
  case Phase::to_force:
    return to_force(state);
  case Phase::release:
    return release(state);
  case Phase::eject:
    return eject(state);
  default:
    return close_by(0, state);
  }
}

void Schedule::accept(const Proposal &proposal,
                      const PressState &before,
                      const PressState &after,
                      bool was_cut)
{
  ++steps_done_;
  landed_ = proposal.lands;
  step_.accepted(proposal.strain, was_cut);
  last_driving_ = proposal.driving;
  before_ = before;
  after_ = after;
  const double closed = closing(after) - closing(before);
  if (closed != 0)
    slope_ =
        (force_of_mover(after.force) - force_of_mover(before.force)) / closed;
  const double shortened = before.height - after.height;
  if (std::abs(shortened) > limits_.minimum * before.height)
    volume_slope_ =
        (1 / before.mean_density - 1 / after.mean_density) / shortened;
  const double strain =
      std::abs((after.top - after.bottom) / (before.top - before.bottom) - 1);
  if (phase_ == Phase::eject && strain > 0)
    step_.limit(proposal.strain * limits_.unloading / strain);
}

double Schedule::progress(const PressState &state) const
{
  if (finished() || phase_ == Phase::none)
    return 0;
  if (now().kind == StageKind::eject && phase_ != Phase::eject)
    return 0; // the compact has not moved yet
  if (reached(state))
    return 1;
  double done = 0;
  const double force = force_of_mover(state.force);
  const double first_force = force_of_mover(begin_.force);
  if (phase_ == Phase::hold)
    done = double(steps_done_) / now().steps;
  else if (phase_ == Phase::to_force)
    done = (force - first_force) / (target_force_ - first_force);
  else if (phase_ == Phase::release)
    done = 1 - force / first_force;
  else if (first_remaining_ > 0)
    done = 1 - remaining(state) / first_remaining_;
  return std::clamp(done, 0., 1.);
}
} // namespace tamp::fem
