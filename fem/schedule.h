// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_schedule_h
#define fem_schedule_h

#include <fem/die_settings.h>
#include <fem/step_control.h>
#include <fem/tool_contact.h>

#include <optional>
#include <vector>

namespace tamp::fem
{
/// What the schedule looks at after an accepted step.
struct PressState {
  double height = 0;             ///< of the compact [m]
  double top = 0;                ///< z of the upper punch [m]
  double upper_displacement = 0; ///< downwards, since the start [m]
  double lower_displacement = 0; ///< upwards, since the start [m]
  double upper_force = 0;        ///< [N]
  double peak_force = 0;         ///< largest of the upper punch so far [N]
  double mean_density = 0;       ///< relative [-]
};

/// A step that is to be tried.
struct Proposal {
  PunchMotion motion;
  double driving = 0; ///< motion that an extrapolation scales with [m]
  double strain = 0;  ///< size of the step, of the height [-]
  bool lands = false; ///< reaches the target: the phase ends with it
};

/// The stages of a run, one after the other, as proposals of punch motions. A
/// stage has one phase, ejection two: the load on the upper punch is changed
/// first, then the lower punch moves. Targets are met exactly: the last motion
/// towards a density or a displacement is what remains, the last one towards a
/// force loads the punch with it.
class Schedule
{
public:
  /// @param rim  z of the die's upper rim [m]
  Schedule(const std::vector<Stage> &stages,
           const StepLimits &limits,
           double rim);

  bool finished() const { return stage_ >= stages_.size(); }
  unsigned stage() const { return stage_; }
  /// Counts the phases begun: motions of different phases are unlike.
  unsigned phase() const { return phase_count_; }
  /// Does the punch press on in this stage?
  bool presses() const;
  /// Is the current stage still to be begun?
  bool at_stage_begin() const { return phase_ == Phase::none; }
  void begin_stage(const PressState &state);

  /// The next step of the stage; none if the stage has ended, in which case the
  /// next stage is the current one.
  std::optional<Proposal> propose(const PressState &state);

  /// The same step, shorter; none if it would be below the minimum.
  std::optional<Proposal> cut(const Proposal &proposal,
                              const PressState &state) const;

  /// A loaded step to the target if `proposal`, found to end with `force` on
  /// the upper punch, goes past it.
  std::optional<Proposal> instead(const Proposal &proposal,
                                  const PressState &state,
                                  double force) const;

  /// The step was taken. @param was_cut  at least once
  void accept(const Proposal &proposal,
              const PressState &before,
              const PressState &after,
              bool was_cut);

  /// Share of the stage that is done, 0 to 1.
  double progress(const PressState &state) const;

private:
  enum class Phase { none, to_distance, to_force, eject, hold };

  const Stage &now() const { return stages_[stage_]; }
  void begin_phase(Phase phase, const PressState &state);
  double remaining(const PressState &state) const;
  std::optional<Proposal> move_upper(const PressState &state) const;
  std::optional<Proposal> move_lower(const PressState &state) const;
  std::optional<Proposal> move_to_force(const PressState &state) const;
  std::optional<Proposal> rest() const;

  std::vector<Stage> stages_;
  StepLimits limits_;
  double rim_;
  unsigned stage_ = 0, phase_count_ = 0;
  Phase phase_ = Phase::none;
  StepControl step_;
  PressState begin_;          ///< of the phase
  double first_remaining_ = 0; ///< at the begin of the phase [m]
  double target_force_ = 0;
  double direction_ = 1; ///< of the force: 1 up, -1 down
  double slope_ = 0;     ///< d force / d motion of the last step [N/m]
  double last_driving_ = 0, last_upper_ = 0;
  unsigned steps_done_ = 0;
  bool landed_ = false;
};
} // namespace tamp::fem

#endif
