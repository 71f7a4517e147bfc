// SPDX-License-Identifier: BSD-3-Clause
#include <fem/path_walk.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tamp::fem
{
using dealii::Tensor;
using path::components;
using path::difference;
using path::largest;
using path::Six;
using path::StressSearch;
using path::stretch;

namespace
{
constexpr double most_cuts = 256;
} // namespace

PathWalk::PathWalk(MaterialPoints &points,
                   const std::vector<PathStage> &stages,
                   std::function<void(unsigned)> stage_begins,
                   const double stress_tolerance)
    : probe_(points), stages_(stages), stage_begins_(std::move(stage_begins)),
      tolerance_(stress_tolerance)
{
  state_.F = state_.rotation = dealii::unit_symmetric_tensor<3>();
}

std::optional<PathEnd> PathWalk::advance()
{
  if (!state_.started)
    return start();
  for (; state_.stage < stages_.size(); ++state_.stage, state_.begun = false) {
    if (!state_.begun)
      begin();
    if (const auto end = move(); end != PathEnd::finished)
      return end;
  }
  return PathEnd::finished;
}

void PathWalk::pack(std::vector<char> &bytes) const
{
  append_state(bytes, state_);
}

void PathWalk::unpack(StateBytes &bytes)
{
  State state;
  bytes.take(state);
  if (state.stage > stages_.size())
    throw std::runtime_error("the stored path has other stages");
  state_ = state;
  probe_.stand_at(state_.F);
  if (state_.begun)
    aim();
}

std::optional<PathEnd> PathWalk::start()
{
  const Response &start = probe_.evaluate(stretch(state_.strain), Want::stress);
  if (start.status == Status::failed)
    return PathEnd::not_converged;
  state_.started = true;
  state_.stress = components(start.stress);
  report();
  return {};
}

void PathWalk::begin()
{
  if (stage_begins_)
    stage_begins_(state_.stage);
  State &now = state_;
  now.begun = true;
  now.done = false;
  now.next = 0;
  now.place = now.last_step = 0;
  now.begin_F = now.from_F = now.F;
  now.begin_strain = now.end_strain = now.strain;
  now.begin_stress = now.end_stress = now.stress;
  if (stage().deviatoric)
    now.begin_strain[2] = now.end_strain[2] =
        now.strain[2] - 0.5 * (now.strain[0] + now.strain[1]);
  double target = 0;
  for (unsigned i = 0; i < 6; ++i) {
    const ComponentTarget &component = stage().components[i];
    if (component.control == ComponentTarget::Control::stress) {
      now.begin_stress[i] += stage().axial_share * now.stress[2];
      now.end_stress[i] = component.value;
      target = std::max(target, std::abs(component.value));
    } else
      now.end_strain[i] =
          component.value + (component.relative ? now.begin_strain[i] : 0);
  }
  now.stress_scale = std::max(largest(now.begin_stress), target);
  const double way = largest(difference(now.end_strain, now.begin_strain));
  now.nominal =
      1 / std::max({1.,
                    1. * stage().minimum_steps,
                    std::ceil(way / stage().maximum_increment - 1e-6)});
  now.longest = now.nominal;
  const bool listed = !stage().gradients.empty() || !stage().increments.empty();
  now.ahead = listed ? 1 : now.nominal;
  now.done = !listed && stage().has_until && beyond(now.stress);
  aim();
}

/// What the increments of the stage have in common.
void PathWalk::aim()
{
  if (state_.stage == stages_.size())
    return;
  goal_ = {};
  goal_.rotation = state_.rotation;
  goal_.tolerance = tolerance_;
  goal_.largest_correction = stage().maximum_increment;
  goal_.axial_share = stage().axial_share;
  goal_.deviatoric = stage().deviatoric;
  goal_.stress_scale = state_.stress_scale;
  for (unsigned i = 0; i < 6; ++i)
    if (stage().components[i].control == ComponentTarget::Control::stress)
      goal_.free.push_back(i);
}

/// Takes an increment of the stage; `finished`: it has none left.
std::optional<PathEnd> PathWalk::move()
{
  if (state_.done ||
      (state_.last_step > 0 && stage().enough && stage().enough()))
    return PathEnd::finished;
  if (!stage().increments.empty())
    return follow_increments();
  if (!stage().gradients.empty())
    return follow_gradients();
  if (state_.place >= 1)
    return stage().has_until ? PathEnd::not_reached : PathEnd::finished;
  return follow_components();
}

std::optional<PathEnd> PathWalk::follow_components()
{
  constexpr double smallest_step = 1e-9;
  const double place = state_.place;
  for (double step = state_.ahead;;) {
    if (place + 1.001 * step >= 1)
      step = 1 - place;
    if (!attempt(place + step, step)) {
      step /= 2;
      if (step < 0.999 * std::min(state_.nominal, 1 - place) / most_cuts)
        return PathEnd::not_converged;
      continue;
    }
    const double size = largest(difference(trial_strain_, state_.strain)) /
                        stage().maximum_increment;
    if (size > 1.5) { // the stress asks for more strain than expected
      state_.nominal = step = step * std::max(0.1, 0.9 / size);
      if (state_.nominal < smallest_step)
        return PathEnd::not_converged;
      continue;
    }
    if (stage().has_until && beyond(trial_stress_)) {
      if (!refine(place, step))
        return PathEnd::not_converged;
      state_.done = true;
    }
    accept(step);
    state_.place = step >= 1 - place ? 1 : place + step;
    if (size < 0.5)
      state_.nominal = std::min(state_.longest, 1.5 * state_.nominal);
    state_.ahead = std::min(state_.nominal, 2 * step);
    return {};
  }
}

/// A gradient that fails is cut in equal parts on the straight way from the one
/// before.
std::optional<PathEnd> PathWalk::follow_gradients()
{
  const Tensor<2, 3> &from = state_.from_F,
                     to = stage().gradients[state_.next] * state_.begin_F;
  double &step = state_.ahead;
  while (true) {
    const double next =
        state_.place + 1.001 * step >= 1 ? 1 : state_.place + step;
    probe_.begin_attempt();
    const Response &trial = probe_.evaluate(
        next < 1 ? from + next * (to - from) : to, Want::stress);
    if (trial.status != Status::failed &&
        std::isfinite(largest(components(trial.stress)))) {
      state_.place = next;
      break;
    }
    step /= 2;
    if (step < 1 / most_cuts)
      return PathEnd::not_converged;
  }
  accept_gradient();
  if (state_.place >= 1) {
    state_.from_F = state_.F;
    state_.place = 0;
    state_.ahead = 1;
    state_.done = ++state_.next == stage().gradients.size();
  }
  return {};
}

std::optional<PathEnd> PathWalk::follow_increments()
{
  probe_.begin_attempt();
  const Response &trial =
      probe_.evaluate_increment(stage().increments[state_.next], Want::stress);
  if (trial.status == Status::failed)
    return PathEnd::not_converged;
  accept_gradient();
  state_.done = ++state_.next == stage().increments.size();
  return {};
}

/// Finds the trial at a place between 0 and 1 of the stage.
bool PathWalk::attempt(const double place, const double step)
{
  const auto between = [place](const double a, const double b) {
    return place < 1 ? a + place * (b - a) : b;
  };
  for (unsigned i = 0; i < 6; ++i) {
    goal_.strain[i] = between(state_.begin_strain[i], state_.end_strain[i]);
    goal_.stress[i] = between(state_.begin_stress[i], state_.end_stress[i]);
  }
  bool found = false;
  if (state_.last_step > 0 && !goal_.free.empty()) {
    for (unsigned i = 0; i < 6; ++i)
      trial_strain_[i] =
          state_.strain[i] + state_.last_increment[i] * step / state_.last_step;
    found = StressSearch(probe_, goal_).find(trial_strain_);
  }
  if (!found) {
    trial_strain_ = state_.strain;
    found = StressSearch(probe_, goal_).find(trial_strain_);
  }
  trial_stress_ = components(probe_.response().stress);
  return found;
}

bool PathWalk::beyond(const Six &stress) const
{
  const double value = stress[stage().until_component];
  return stage().until_above ? value >= stage().until_stress
                             : value <= stage().until_stress;
}

/// Shortens the step until the trial meets the stress that ends the stage:
/// regula falsi, every third time bisection.
bool PathWalk::refine(const double place, double &step)
{
  const double until = stage().until_stress;
  const auto off = [&](const Six &stress) {
    return stress[stage().until_component] - until;
  };
  const double near =
      0.01 *
      (std::abs(until) > 0 ? std::abs(until) : largest(state_.begin_stress));
  double low = 0, high = step, off_low = off(state_.stress);
  double off_high = off(trial_stress_);
  for (unsigned i = 1; i <= 40; ++i) {
    if (std::abs(off(trial_stress_)) <= near)
      return true;
    const double share = i % 3 == 0 ? 0.5 : off_low / (off_low - off_high);
    step = low + std::clamp(share, 0.02, 0.98) * (high - low);
    if (!attempt(place + step, step))
      return false;
    (beyond(trial_stress_) ? high : low) = step;
    (beyond(trial_stress_) ? off_high : off_low) = off(trial_stress_);
  }
  step = high; // the stress jumps: take the far side
  return attempt(place + step, step);
}

void PathWalk::accept(const double step)
{
  probe_.commit();
  state_.last_increment = difference(trial_strain_, state_.strain);
  state_.last_step = step;
  state_.strain = trial_strain_;
  state_.stress = trial_stress_;
  ++state_.step;
  report();
}

void PathWalk::accept_gradient()
{
  probe_.commit();
  const path::LeftSplit split = path::left_split(probe_.F());
  state_.strain = split.strain;
  state_.rotation = split.rotation;
  state_.stress = components(probe_.response().stress);
  ++state_.step;
  report();
}

void PathWalk::report()
{
  state_.F = probe_.F();
  last_ = {state_.step, state_.stage, probe_.F(), probe_.response()};
}
} // namespace tamp::fem
