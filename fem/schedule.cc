// SPDX-License-Identifier: BSD-3-Clause
#include <fem/schedule.h>

#include <cmath>

namespace tamp::fem
{
namespace
{
/// The first step against the direction of the last loading is this share of
/// the usual first one: friction reverses within it.
constexpr double gentle = 0.25;
/// An unloading step goes at most this share of the way to zero force.
constexpr double unloading_share = 0.7;
/// Nearer to its target than this share of the peak, a force is imposed.
constexpr double landing_share = 0.05;
/// Shares of the height, of a force: below, a target is met.
constexpr double met = 1e-9;

double peak_or_force(const PressState &state, double force)
{
  return std::max(state.peak_force, std::abs(force));
}
} // namespace

Schedule::Schedule(const std::vector<Stage> &stages,
                   const StepLimits &limits,
                   double rim)
    : stages_(stages), limits_(limits), rim_(rim)
{
}

bool Schedule::presses() const
{
  return !finished() &&
         (now().kind == StageKind::press || now().kind == StageKind::hold);
}

void Schedule::begin_stage(const PressState &state)
{
  const Stage &stage = now();
  if (stage.target == StageTarget::force)
    target_force_ = stage.value;
  if (stage.target == StageTarget::peak_share)
    target_force_ = stage.value * state.peak_force;
  if (stage.kind == StageKind::hold) {
    begin_phase(Phase::hold, state);
  } else if (stage.kind == StageKind::eject) {
    target_force_ = stage.hold_share * state.peak_force;
    const bool loaded = std::abs(state.upper_force - target_force_) <=
                        1e-6 * peak_or_force(state, target_force_);
    begin_phase(loaded ? Phase::eject : Phase::to_force, state);
  } else {
    const bool to_force = stage.target == StageTarget::force ||
                          stage.target == StageTarget::peak_share;
    begin_phase(to_force ? Phase::to_force : Phase::to_distance, state);
  }
}

void Schedule::begin_phase(Phase phase, const PressState &state)
{
  phase_ = phase;
  ++phase_count_;
  begin_ = state;
  landed_ = false;
  steps_done_ = 0;
  slope_ = last_driving_ = last_upper_ = 0;
  direction_ = target_force_ >= state.upper_force ? 1 : -1;
  first_remaining_ = remaining(state);
  const bool loads = now().kind == StageKind::press ||
                     (phase == Phase::to_force && direction_ > 0);
  const double largest = loads ? limits_.maximum : limits_.unloading;
  step_ = StepControl(
      loads ? limits_.first : gentle * std::min(limits_.first, largest),
      largest,
      limits_.growth);
}

double Schedule::remaining(const PressState &state) const
{
  const Stage &stage = now();
  if (phase_ == Phase::eject)
    return stage.target == StageTarget::rim
               ? rim_ - state.top
               : stage.value -
                     (state.lower_displacement - begin_.lower_displacement);
  if (stage.target == StageTarget::density)
    return state.height * (1 - state.mean_density / stage.value);
  return stage.value -
         std::abs(state.upper_displacement - begin_.upper_displacement);
}

std::optional<Proposal> Schedule::propose(const PressState &state)
{
  std::optional<Proposal> proposal;
  switch (phase_) {
  case Phase::none:
    break;
  case Phase::to_distance:
    proposal = move_upper(state);
    break;
  case Phase::to_force:
    proposal = move_to_force(state);
    break;
  case Phase::eject:
    proposal = move_lower(state);
    break;
  case Phase::hold:
    proposal = rest();
    break;
  }
  if (!proposal && phase_ == Phase::to_force &&
      now().kind == StageKind::eject) {
    begin_phase(Phase::eject, state);
    return propose(state);
  }
  if (!proposal) {
    ++stage_;
    phase_ = Phase::none;
  }
  return proposal;
}

std::optional<Proposal> Schedule::move_upper(const PressState &state) const
{
  const double rest = remaining(state);
  if (landed_ || rest <= met * state.height)
    return {};
  const Portion portion = portion_of(rest, step_.strain() * state.height);
  Proposal proposal;
  proposal.motion.upper =
      now().kind == StageKind::press ? -portion.length : portion.length;
  proposal.driving = portion.length;
  proposal.strain = portion.length / state.height;
  proposal.lands = portion.lands;
  return proposal;
}

std::optional<Proposal> Schedule::move_lower(const PressState &state) const
{
  // At the rim the height may still have changed a little after landing.
  const double tolerance = now().target == StageTarget::rim ? 1e-6 : met;
  const double rest = remaining(state);
  if (rest <= tolerance * state.height)
    return {};
  const Portion portion = portion_of(rest, step_.strain() * state.height);
  Proposal proposal;
  proposal.motion.lower = portion.length;
  proposal.motion.upper_is_loaded = true;
  proposal.motion.upper_force = target_force_;
  proposal.motion.upper =
      last_driving_ > 0 ? last_upper_ * portion.length / last_driving_
                        : portion.length;
  proposal.driving = portion.length;
  proposal.strain = portion.length / state.height;
  return proposal;
}

std::optional<Proposal> Schedule::move_to_force(const PressState &state) const
{
  const double missing = direction_ * (target_force_ - state.upper_force);
  const double peak = peak_or_force(state, target_force_);
  if (landed_ || missing <= met * peak)
    return {};
  double length = step_.strain() * state.height;
  Proposal proposal;
  if (slope_ > 0) {
    const double needed = missing / slope_;
    if (direction_ < 0)
      length =
          std::min(length, unloading_share * state.upper_force / slope_);
    if (needed <= 1.2 * length ||
        (direction_ < 0 && missing <= landing_share * peak)) {
      length = needed;
      proposal.lands = true;
      proposal.motion.upper_is_loaded = true;
      proposal.motion.upper_force = target_force_;
    } else if (needed < 2 * length) {
      length = 0.5 * needed;
    }
  }
  proposal.motion.upper = -direction_ * length;
  proposal.driving = length;
  proposal.strain = length / state.height;
  return proposal;
}

std::optional<Proposal> Schedule::rest() const
{
  if (steps_done_ >= now().steps)
    return {};
  return Proposal();
}

std::optional<Proposal> Schedule::cut(const Proposal &proposal,
                                      const PressState &state) const
{
  Proposal shorter = proposal;
  shorter.motion.upper *= limits_.cut;
  shorter.motion.lower *= limits_.cut;
  shorter.driving *= limits_.cut;
  shorter.strain *= limits_.cut;
  shorter.lands = false;
  if (shorter.motion.upper_is_loaded && phase_ == Phase::to_force)
    shorter.motion.upper_force =
        state.upper_force +
        limits_.cut * (proposal.motion.upper_force - state.upper_force);
  if (shorter.strain < limits_.minimum)
    return {};
  return shorter;
}

std::optional<Proposal> Schedule::instead(const Proposal &proposal,
                                          const PressState &state,
                                          double force) const
{
  if (phase_ != Phase::to_force || proposal.motion.upper_is_loaded)
    return {};
  const double past = direction_ * (force - target_force_);
  if (past <= 1e-6 * peak_or_force(state, target_force_))
    return {};
  const double share =
      (target_force_ - state.upper_force) / (force - state.upper_force);
  Proposal loaded = proposal;
  loaded.motion.upper_is_loaded = true;
  loaded.motion.upper_force = target_force_;
  loaded.motion.upper *= share;
  loaded.driving *= share;
  loaded.strain *= share;
  loaded.lands = true;
  return loaded;
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
  last_upper_ = before.upper_displacement - after.upper_displacement;
  if (phase_ == Phase::to_force && last_upper_ != 0) {
    slope_ = (after.upper_force - before.upper_force) / -last_upper_;
  }
}

double Schedule::progress(const PressState &state) const
{
  double done = 1;
  if (finished() || phase_ == Phase::none)
    return 0;
  if (phase_ == Phase::hold)
    done = double(steps_done_) / now().steps;
  else if (landed_ && phase_ != Phase::eject)
    done = 1;
  else if (phase_ == Phase::to_force)
    done = (state.upper_force - begin_.upper_force) /
           (target_force_ - begin_.upper_force);
  else if (first_remaining_ > 0)
    done = 1 - remaining(state) / first_remaining_;
  if (phase_ == Phase::to_force && now().kind == StageKind::eject)
    done = 0; // the compact has not moved yet
  return std::clamp(done, 0., 1.);
}
} // namespace tamp::fem
