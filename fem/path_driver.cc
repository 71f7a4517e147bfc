// SPDX-License-Identifier: BSD-3-Clause
#include <fem/path_driver.h>
#include <fem/stress_search.h>

#include <algorithm>
#include <cmath>

namespace tamp::fem
{
using dealii::Tensor;

namespace
{
using path::components;
using path::difference;
using path::Goal;
using path::largest;
using path::Probe;
using path::Six;
using path::StressSearch;
using path::stretch;

/// Walks the stages; knows the committed strain and stress.
class Walk
{
public:
  Walk(MaterialPoints &points,
       const std::function<void(const PathRecord &)> &observe,
       const double stress_tolerance)
      : probe_(points), observe_(observe), tolerance_(stress_tolerance)
  {
    const Response &start = probe_.evaluate(stretch(strain_), Want::stress);
    started_ = start.status != Status::failed;
    if (!started_)
      return;
    stress_ = components(start.stress);
    report();
  }

  /// Whether the point has a state to start from.
  bool started() const { return started_; }

  PathEnd run(const PathStage &stage, const unsigned index)
  {
    begin(stage, index);
    if (!stage.gradients.empty())
      return follow(stage.gradients);
    if (stage.has_until && beyond(stress_))
      return PathEnd::finished;
    constexpr double smallest_step = 1e-9;
    const double longest = nominal_;
    for (double place = 0, step = nominal_; place < 1;) {
      if (place + 1.001 * step >= 1)
        step = 1 - place;
      if (!attempt(place + step, step)) {
        step /= 2;
        if (step < 0.999 * std::min(nominal_, 1 - place) / most_cuts)
          return PathEnd::not_converged;
        continue;
      }
      const double size =
          largest(difference(trial_strain_, strain_)) / stage.maximum_increment;
      if (size > 1.5) { // the stress asks for more strain than expected
        nominal_ = step = step * std::max(0.1, 0.9 / size);
        if (nominal_ < smallest_step)
          return PathEnd::not_converged;
        continue;
      }
      if (stage.has_until && beyond(trial_stress_)) {
        if (!refine(place, step))
          return PathEnd::not_converged;
        accept(step);
        return PathEnd::finished;
      }
      accept(step);
      if (stage.enough && stage.enough())
        return PathEnd::finished;
      place = step >= 1 - place ? 1 : place + step;
      if (size < 0.5)
        nominal_ = std::min(longest, 1.5 * nominal_);
      step = std::min(nominal_, 2 * step);
    }
    return stage.has_until ? PathEnd::not_reached : PathEnd::finished;
  }

private:
  static constexpr double most_cuts = 256;

  /// Takes the gradients one by one; one that fails is cut in equal parts on
  /// the straight way from the one before.
  PathEnd follow(const std::vector<Tensor<2, 3>> &gradients)
  {
    const Tensor<2, 3> start = probe_.F();
    for (const Tensor<2, 3> &gradient : gradients) {
      const Tensor<2, 3> from = probe_.F(), to = gradient * start;
      for (double place = 0, step = 1; place < 1;) {
        const double next = place + 1.001 * step >= 1 ? 1 : place + step;
        probe_.begin_attempt();
        const Response &trial = probe_.evaluate(
            next < 1 ? from + next * (to - from) : to, Want::stress);
        trial_stress_ = components(trial.stress);
        if (trial.status == Status::failed ||
            !std::isfinite(largest(trial_stress_))) {
          step /= 2;
          if (step < 1 / most_cuts)
            return PathEnd::not_converged;
          continue;
        }
        probe_.commit();
        const path::LeftSplit split = path::left_split(probe_.F());
        strain_ = split.strain;
        goal_.rotation = split.rotation;
        stress_ = trial_stress_;
        ++step_;
        report();
        place = next;
      }
    }
    return PathEnd::finished;
  }

  void begin(const PathStage &stage, const unsigned index)
  {
    stage_ = &stage;
    index_ = index;
    last_step_ = 0;
    begin_strain_ = end_strain_ = strain_;
    begin_stress_ = end_stress_ = stress_;
    const Tensor<2, 3> rotation = goal_.rotation;
    goal_ = {};
    goal_.rotation = rotation;
    goal_.tolerance = tolerance_;
    goal_.largest_correction = stage.maximum_increment;
    goal_.axial_share = stage.axial_share;
    goal_.deviatoric = stage.deviatoric;
    if (stage.deviatoric)
      begin_strain_[2] = end_strain_[2] =
          strain_[2] - 0.5 * (strain_[0] + strain_[1]);
    for (unsigned i = 0; i < 6; ++i) {
      const ComponentTarget &target = stage.components[i];
      if (target.control == ComponentTarget::Control::stress) {
        goal_.free.push_back(i);
        begin_stress_[i] += stage.axial_share * stress_[2];
        end_stress_[i] = target.value;
      } else
        end_strain_[i] =
            target.value + (target.relative ? begin_strain_[i] : 0);
    }
    goal_.stress_scale = largest(begin_stress_);
    for (const unsigned i : goal_.free)
      goal_.stress_scale =
          std::max(goal_.stress_scale, std::abs(end_stress_[i]));
    const double way = largest(difference(end_strain_, begin_strain_));
    nominal_ = 1 / std::max({1.,
                             1. * stage.minimum_steps,
                             std::ceil(way / stage.maximum_increment - 1e-6)});
  }

  /// Finds the trial at a place between 0 and 1 of the stage.
  bool attempt(const double place, const double step)
  {
    const auto between = [place](const double a, const double b) {
      return place < 1 ? a + place * (b - a) : b;
    };
    for (unsigned i = 0; i < 6; ++i) {
      goal_.strain[i] = between(begin_strain_[i], end_strain_[i]);
      goal_.stress[i] = between(begin_stress_[i], end_stress_[i]);
    }
    bool found = false;
    if (last_step_ > 0 && !goal_.free.empty()) {
      for (unsigned i = 0; i < 6; ++i)
        trial_strain_[i] = strain_[i] + last_increment_[i] * step / last_step_;
      found = StressSearch(probe_, goal_).find(trial_strain_);
    }
    if (!found) {
      trial_strain_ = strain_;
      found = StressSearch(probe_, goal_).find(trial_strain_);
    }
    trial_stress_ = components(probe_.response().stress);
    return found;
  }

  bool beyond(const Six &stress) const
  {
    const double value = stress[stage_->until_component];
    return stage_->until_above ? value >= stage_->until_stress
                               : value <= stage_->until_stress;
  }

  /// Shortens the step until the trial meets the stress that ends the stage:
  /// regula falsi, every third time bisection.
  bool refine(const double place, double &step)
  {
    const auto off = [this](const Six &stress) {
      return stress[stage_->until_component] - stage_->until_stress;
    };
    const double near = 0.01 * (std::abs(stage_->until_stress) > 0
                                    ? std::abs(stage_->until_stress)
                                    : largest(begin_stress_));
    double low = 0, high = step, off_low = off(stress_);
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

  void accept(const double step)
  {
    probe_.commit();
    last_increment_ = difference(trial_strain_, strain_);
    last_step_ = step;
    strain_ = trial_strain_;
    stress_ = trial_stress_;
    ++step_;
    report();
  }

  void report() const
  {
    if (observe_)
      observe_({step_, index_, probe_.F(), probe_.response()});
  }

  Probe probe_;
  const std::function<void(const PathRecord &)> &observe_;
  double tolerance_ = 0;
  unsigned step_ = 0, index_ = 0;
  Six strain_{}, stress_{}, trial_strain_{}, trial_stress_{};

  const PathStage *stage_ = nullptr;
  Goal goal_;
  double nominal_ = 1, last_step_ = 0;
  Six begin_strain_{}, end_strain_{}, begin_stress_{}, end_stress_{};
  bool started_ = false;
  Six last_increment_{};
};
} // namespace

PathEnd drive_path(MaterialPoints &points,
                   const std::vector<PathStage> &stages,
                   const std::function<void(unsigned)> &stage_begins,
                   const std::function<void(const PathRecord &)> &observe,
                   const double stress_tolerance)
{
  Walk walk(points, observe, stress_tolerance);
  if (!walk.started())
    return PathEnd::not_converged;
  for (unsigned index = 0; index < stages.size(); ++index) {
    if (stage_begins)
      stage_begins(index);
    const PathEnd end = walk.run(stages[index], index);
    if (end != PathEnd::finished)
      return end;
  }
  return PathEnd::finished;
}

PathEnd drive_increments(MaterialPoints &points,
                         const std::vector<Tensor<2, 3>> &increments,
                         const std::function<void(const PathRecord &)> &observe)
{
  std::vector<Deformation> deformation(points.size());
  std::vector<Response> response(points.size());
  const auto evaluate = [&](const Tensor<2, 3> &relative_F) {
    std::ranges::fill(deformation, Deformation{relative_F});
    points.begin_attempt();
    points.evaluate(deformation, Want::stress, response);
    return response[0].status != Status::failed;
  };
  PathRecord record;
  record.F = dealii::unit_symmetric_tensor<3>();
  if (!evaluate(record.F))
    return PathEnd::not_converged;
  record.response = response[0];
  if (observe)
    observe(record);
  for (const Tensor<2, 3> &relative_F : increments) {
    if (!evaluate(relative_F))
      return PathEnd::not_converged;
    points.commit();
    ++record.step;
    record.F = relative_F * record.F;
    record.response = response[0];
    if (observe)
      observe(record);
  }
  return PathEnd::finished;
}
} // namespace tamp::fem
