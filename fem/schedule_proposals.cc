// SPDX-License-Identifier: BSD-3-Clause
#include <fem/schedule.h>

#include <algorithm>
#include <cmath>

namespace tamp::fem
{
namespace
{
/// An unloading step goes at most this share of the way to zero force.
constexpr double unloading_share = 0.7;
/// Nearer to its target than this share of the peak, a force is imposed.
constexpr double landing_share = 0.05;
/// What a punch goes back in the end, as a multiple of the way on which its
/// force should vanish: less steeply than before if it falls as in Hertz's
/// contact. Then it is clear of the compact by this share of the height.
constexpr double release_excess = 2, clearance = 1e-3;
/// A free punch leads the compact on its way out by this share of the way: what
/// friction had shortened springs back, and must not touch it.
constexpr double lead = 0.05;
} // namespace

Proposal Schedule::close_by(double length, const PressState &state) const
{
  Proposal proposal;
  proposal.driving = std::abs(length);
  proposal.strain = number_of_movers() * proposal.driving / state.height;
  ToolMotion &upper = proposal.motion[upper_punch];
  ToolMotion &lower = proposal.motion[lower_punch];
  if (movers_ != Pressing::lower)
    upper.displacement = -length;
  if (movers_ != Pressing::upper)
    lower.displacement = length;
  if (floating_die_ && now().kind != StageKind::eject) {
    ToolMotion &die = proposal.motion[die_wall];
    die.loaded = true;
    die.displacement =
        last_driving_ > 0
            ? (after_.die_displacement - before_.die_displacement) *
                  proposal.driving / last_driving_
            : 0.5 * (upper.displacement + lower.displacement);
  }
  return proposal;
}

void Schedule::load_mover(Proposal &proposal) const
{
  const bool lower = movers_ == Pressing::lower;
  ToolMotion &mover = proposal.motion[lower ? lower_punch : upper_punch];
  mover.loaded = true;
  mover.force = lower ? -target_force_ : target_force_;
  proposal.lands = true;
}

Proposal Schedule::to_distance(const PressState &state) const
{
  const Portion portion = portion_of(
      remaining(state), step_.strain() * state.height / number_of_movers());
  Proposal proposal = close_by(
      now().kind == StageKind::press ? portion.length : -portion.length, state);
  proposal.lands = portion.lands;
  return proposal;
}

Proposal Schedule::to_force(const PressState &state) const
{
  const double force = force_of_mover(state.force);
  const double missing = direction_ * (target_force_ - force);
  double length = step_.strain() * state.height / number_of_movers();
  bool lands = false;
  if (slope_ > 0) {
    const double needed = missing / slope_;
    if (direction_ < 0)
      length = std::min(length, unloading_share * force / slope_);
    lands = needed <= 1.2 * length ||
            (direction_ < 0 &&
             missing <= landing_share * peak_or_force(state, force));
    if (lands)
      length = needed;
    else if (needed < 2 * length)
      length = 0.5 * needed;
  }
  Proposal proposal = close_by(direction_ * length, state);
  if (lands)
    load_mover(proposal);
  return proposal;
}

Proposal Schedule::release(const PressState &state) const
{
  const double force = force_of_mover(state.force);
  const double length = step_.strain() * state.height;
  if (slope_ <= 0)
    return close_by(-length, state);
  const double needed = force / slope_;
  if (force > landing_share * peak_or_force(state, force) || needed > length)
    return close_by(-std::min(length, unloading_share * needed), state);
  Proposal proposal =
      close_by(-release_excess * needed - clearance * state.height, state);
  proposal.driving = needed; // the compact does not follow further
  proposal.lands = true;
  return proposal;
}

double Schedule::longest_ejection(const PressState &state) const
{
  const double step = step_.strain() * state.height;
  const double gap = state.rim - state.top;
  const double passing = limits_.rim * state.element_height;
  if (gap >= step || passing <= 0)
    return step;
  return std::min(step, std::max(gap, passing));
}

Proposal Schedule::eject(const PressState &state) const
{
  const Portion portion = portion_of(remaining(state), longest_ejection(state));
  const bool pushes = now().ejection == Ejection::push;
  Proposal proposal;
  ToolMotion &upper = proposal.motion[upper_punch];
  proposal.motion[lower_punch].displacement = pushes ? portion.length : 0;
  proposal.motion[die_wall].displacement = pushes ? 0 : -portion.length;
  upper.displacement = pushes ? portion.length : 0;
  if (target_force_ <= 0) {
    upper.displacement += lead * portion.length;
  } else {
    upper.loaded = true;
    upper.force = target_force_;
    if (last_driving_ > 0)
      upper.displacement =
          (before_.upper_displacement - after_.upper_displacement) *
          portion.length / last_driving_;
  }
  proposal.driving = portion.length;
  proposal.strain = portion.length / state.height;
  proposal.lands = portion.lands;
  return proposal;
}

std::optional<Proposal> Schedule::cut(const Proposal &proposal,
                                      const PressState &state) const
{
  Proposal shorter = proposal;
  shorter.driving *= limits_.cut;
  shorter.strain *= limits_.cut;
  shorter.lands = false;
  for (unsigned tool = 0; tool < number_of_tools; ++tool) {
    ToolMotion &motion = shorter.motion[tool];
    motion.displacement *= limits_.cut;
    if (motion.loaded && tool != die_wall && phase_ == Phase::to_force)
      motion.force =
          state.force[tool] + limits_.cut * (motion.force - state.force[tool]);
  }
  if (shorter.strain < limits_.minimum)
    return {};
  return shorter;
}

std::optional<Proposal> Schedule::instead(const Proposal &proposal,
                                          const PressState &state,
                                          const ForceOnTools &force) const
{
  const unsigned mover = movers_ == Pressing::lower ? lower_punch : upper_punch;
  if (phase_ != Phase::to_force || proposal.motion[mover].loaded)
    return {};
  const double end = force_of_mover(force), begin = force_of_mover(state.force);
  if (direction_ * (end - target_force_) <=
      1e-6 * peak_or_force(state, target_force_))
    return {};
  const double share = (target_force_ - begin) / (end - begin);
  Proposal loaded = proposal;
  loaded.driving *= share;
  loaded.strain *= share;
  for (ToolMotion &motion : loaded.motion)
    motion.displacement *= share;
  load_mover(loaded);
  return loaded;
}

} // namespace tamp::fem
