// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_schedule_h
#define fem_schedule_h

#include <fem/die_settings.h>
#include <fem/press_state.h>
#include <fem/state_bytes.h>
#include <fem/step_control.h>
#include <fem/tool_motion.h>

#include <optional>
#include <string>
#include <vector>

namespace tamp::fem
{
/// A step that is to be tried.
struct Proposal {
  Motion motion;
  double driving = 0; ///< motion that an extrapolation scales with [m]
  double strain = 0;  ///< size of the step, of the height [-]
  bool lands = false; ///< meant to reach the target of the phase
};

/// The stages of a run, one after the other, as proposals of tool motions. A
/// stage has one phase, ejection two: the load on the upper punch is changed
/// first, then the compact leaves the die; nodes that passed its rim in the
/// last step are let go in one more at rest. Targets are met exactly: the last
/// motion towards a density or a displacement is what remains, the last one
/// towards a force loads the punch with it. A punch that is to bear nothing is
/// never loaded: it goes back step by step, the last time a little further than
/// its force needs. A floating die is loaded with nothing at all and follows
/// friction; it stands still while the compact is ejected.
class Schedule
{
public:
  /// Takes the stages, the limits of steps and who carries the die.
  explicit Schedule(const DieSettings &settings);

  bool finished() const { return stage_ >= stages_.size(); }
  unsigned stage() const { return stage_; }
  /// Counts the phases begun: motions of different phases are unlike.
  unsigned phase() const { return phase_count_; }
  /// Does a punch press on in this stage?
  bool presses() const;
  /// Compressive force of the punch that presses, or pressed last; of the upper
  /// one if both do. Zero while ejecting [N].
  double pressing_force(const ForceOnTools &force) const;

  /// Is the compact on its way out of the die?
  bool ejects() const { return phase_ == Phase::eject; }
  /// Share of its pressure that a material point is left by a step that ended
  /// with these forces: what the punch takes back, and the wall of a compact
  /// that passes the rim, is asked for [-].
  double kept_pressure(const Proposal &proposal,
                       const PressState &before,
                       const ForceOnTools &after) const;

  /// Is the current stage still to be begun?
  bool at_stage_begin() const { return phase_ == Phase::none; }
  void begin_stage(const PressState &state);

  /// Why the stage that was begun cannot be done from here on, in a sentence;
  /// nothing if it may be. To be asked before every proposal.
  std::optional<std::string> impossible(const PressState &state) const;

  /// The next step of the stage; none if the stage has ended, in which case the
  /// next stage is the current one.
  std::optional<Proposal> propose(const PressState &state);

  /// The same step, shorter; none if it would be below the minimum.
  std::optional<Proposal> cut(const Proposal &proposal,
                              const PressState &state) const;

  /// A loaded step to the target if `proposal`, found to end with these forces,
  /// goes past it.
  std::optional<Proposal> instead(const Proposal &proposal,
                                  const PressState &state,
                                  const ForceOnTools &force) const;

  /// The step was taken. @param was_cut  at least once
  void accept(const Proposal &proposal,
              const PressState &before,
              const PressState &after,
              bool was_cut);

  /// Share of the stage that is done, 0 to 1.
  double progress(const PressState &state) const;

  /// Appends how far the stages have come; unpack() goes on from there.
  void pack(std::vector<char> &bytes) const;
  void unpack(StateBytes &bytes);

private:
  enum class Phase { none, to_distance, to_force, release, eject, hold };

  const Stage &now() const { return stages_[stage_]; }
  void begin_phase(Phase phase, const PressState &state);
  bool reached(const PressState &state) const;
  std::string cannot_press(const PressState &state) const;
  std::string cannot_change_force(const PressState &state) const;
  static double peak_or_force(const PressState &state, double force);
  /// Way that the moving tools still have to go [m].
  double remaining(const PressState &state) const;
  /// Compressive force of the moving punch [N].
  double force_of_mover(const ForceOnTools &force) const;
  /// How far the moving punch has come towards the other one [m].
  double closing(const PressState &state) const;
  unsigned number_of_movers() const;

  /// The moving punches come closer to each other, by this length each.
  Proposal close_by(double length, const PressState &state) const;
  void load_mover(Proposal &proposal) const;
  Proposal to_distance(const PressState &state) const;
  Proposal to_force(const PressState &state) const;
  Proposal release(const PressState &state) const;
  Proposal eject(const PressState &state) const;
  double longest_ejection(const PressState &state) const;
  template <class Self, class Use>
  static void each_part(Self &self, const Use &use);

  std::vector<Stage> stages_;
  StepLimits limits_;
  bool floating_die_;
  unsigned stage_ = 0, phase_count_ = 0;
  Phase phase_ = Phase::none;
  /// Who presses or pressed last, and who moves in this stage.
  Pressing pressing_ = Pressing::upper, movers_ = Pressing::upper;
  StepControl step_;
  PressState begin_;           ///< of the phase
  double first_remaining_ = 0; ///< at the begin of the phase [m]
  double target_force_ = 0;
  double direction_ = 1;      ///< of the force: 1 up, -1 down
  double slope_ = 0;          ///< d force / d closing in the last step [N/m]
  double volume_slope_ = 0;   ///< d (1 / density) / d height, likewise [1/m]
  double last_driving_ = 0;   ///< of the phase [m]
  PressState before_, after_; ///< the last step of the phase
  unsigned steps_done_ = 0;
  bool landed_ = false;
};
} // namespace tamp::fem

#endif
