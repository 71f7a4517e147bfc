// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_fem_press_trip_h
#define tests_fem_press_trip_h

#include <fem/schedule.h>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace tamp::fem::test
{
/// A few roundings of numbers near one.
inline constexpr double rounding = 1e-12;

/// A press without friction, but for a floating die, that follows the middle of
/// the compact. The powder hardens linearly with its shortening and springs
/// back as (shortening)^power; a punch may leave it.
struct Press {
  static constexpr unsigned elements = 40; ///< along the height
  static constexpr double height = 7e-3, hardening = 1e6, elasticity = 2e7;
  double power = 1;
  double faces = 0; ///< volume between curved faces / area of the punch [m]
  double bulge = 0; ///< volume lost with the square of the strain / filled [-]
  double upper = height, lower = 0, die = 0; ///< z of their edges [m]
  double natural = height;                   ///< height without force [m]
  PressState state;

  Press() { observe(); }

  double shortening_under(double force) const
  {
    return height / 10 *
           std::pow(force / (elasticity * height / 10), 1 / power);
  }

  double force() const
  {
    const double shortening = natural - (upper - lower);
    return shortening <= 0 ? 0
                           : elasticity * height / 10 *
                                 std::pow(shortening / (height / 10), power);
  }

  /// Height at which the powder bears this force.
  double height_under(double force) const
  {
    EXPECT_GT(force, 0) << "a loaded punch without contact goes anywhere";
    return std::min(natural - shortening_under(force),
                    height - force / hardening);
  }

  void move(const Motion &motion)
  {
    const ToolMotion &above = motion[upper_punch], &below = motion[lower_punch];
    if (!below.loaded)
      lower += below.displacement;
    upper = above.loaded ? lower + height_under(above.force)
                         : upper + above.displacement;
    if (below.loaded)
      lower = upper - height_under(-below.force);
    const double yield = hardening * (height - (upper - lower));
    if (force() > yield)
      natural = upper - lower + shortening_under(yield);
    EXPECT_TRUE(!motion[die_wall].loaded || motion[die_wall].force == 0);
    die = motion[die_wall].loaded ? 0.5 * (upper + lower - height)
                                  : die + motion[die_wall].displacement;
    observe();
  }

  void observe()
  {
    state.height = upper - lower;
    state.fill_height = height;
    state.top = std::min(upper, lower + natural);
    state.bottom = lower;
    state.rim = height + die;
    state.upper_displacement = height - upper;
    state.lower_displacement = lower;
    state.die_displacement = die;
    state.force[upper_punch] = force();
    state.force[lower_punch] = -force();
    const double strain = 1 - (state.top - state.bottom) / height;
    state.mean_density =
        0.5 * (height + faces) /
        (height * (1 - strain - bulge * strain * strain) + faces);
    state.element_height = (state.top - state.bottom) / elements;
  }
};

struct Step {
  unsigned stage;
  Proposal proposal;
  PressState before, after;
  bool was_cut;
  double kept; ///< Schedule::kept_pressure()
};

inline DieSettings schedule_of(const std::vector<Stage> &stages)
{
  DieSettings settings;
  settings.stages = stages;
  settings.check();
  return settings;
}

inline Stage press_by(Pressing who, StageTarget target, double value)
{
  return {StageKind::press, target, value, 0, 1, who};
}

inline Stage unload_to(StageTarget target, double value)
{
  return {StageKind::unload, target, value};
}

using Fails = std::function<bool(const Proposal &)>;

/// Runs all stages, or until one is impossible: `problem` says why.
struct Trip {
  Press press;
  std::vector<Step> steps;
  std::string problem;

  explicit Trip(const DieSettings &settings,
                const Press &start = {},
                const Fails &fails = {})
      : press(start)
  {
    Schedule schedule(settings);
    while (!schedule.finished() && problem.empty() && steps.size() < 5000) {
      if (schedule.at_stage_begin())
        schedule.begin_stage(press.state);
      problem = schedule.impossible(press.state).value_or("");
      if (problem.empty())
        if (const auto proposal = schedule.propose(press.state))
          step(schedule, *proposal, fails);
    }
    EXPECT_LT(steps.size(), 5000u);
  }

  void step(Schedule &schedule, Proposal proposal, const Fails &fails)
  {
    bool was_cut = false;
    while (fails && fails(proposal)) {
      proposal = schedule.cut(proposal, press.state).value();
      was_cut = true;
    }
    Press trial = press;
    trial.move(proposal.motion);
    if (const auto loaded =
            schedule.instead(proposal, press.state, trial.state.force)) {
      proposal = *loaded;
      trial = press;
      trial.move(proposal.motion);
    }
    trial.state.peak_force = std::max(
        press.state.peak_force, schedule.pressing_force(trial.state.force));
    steps.push_back(
        {schedule.stage(),
         proposal,
         press.state,
         trial.state,
         was_cut,
         schedule.kept_pressure(proposal, press.state, trial.state.force)});
    schedule.accept(proposal, press.state, trial.state, was_cut);
    press = trial;
    const double progress = schedule.progress(press.state);
    EXPECT_TRUE(progress >= 0 && progress <= 1);
  }

  const PressState &end() const { return press.state; }
  std::vector<Step> of(unsigned stage) const
  {
    std::vector<Step> result;
    for (const Step &step : steps)
      if (step.stage == stage)
        result.push_back(step);
    return result;
  }
};

} // namespace tamp::fem::test

#endif
