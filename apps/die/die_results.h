// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_die_results_h
#define apps_die_die_results_h

#include <apps/run/run_session.h>
#include <fem/die_model.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// What the cells of a step cost and how good they are; zero for continua.
struct StepEffort {
  double evaluations = 0;       ///< of all forces, per cell, in the step
  double worst_unbalance = 0;   ///< [-]
  double worst_hill_mandel = 0; ///< [-]
  double worst_asymmetry = 0;   ///< |skw stress| / |stress| [-]
  double wall_time = 0;         ///< since the start of the run [s]
};

/// Names of the columns of a die's curve.
std::vector<std::string> die_header();
/// The values that belong to die_header(). Stages count from 1.
std::vector<double> die_values(const fem::StepRecord &record,
                               const StepEffort &effort);

/// The key results of a die, gathered step by step.
class DieResults
{
public:
  /// @param force_floor  share of the peak that forces count as at least where
  ///                     their imbalance is judged [-]
  explicit DieResults(double force_floor) : force_floor_(force_floor) {}

  /// @param stage  to which the step belongs.
  void take(const fem::StepRecord &record,
            const fem::Stage &stage,
            const StepEffort &effort);
  /// Hands all results to the session.
  void give(RunSession &session) const;

  /// The step with the largest force of the punch that presses, of the upper
  /// one if both do.
  const fem::StepRecord &peak() const { return peak_; }
  /// Is the last step taken the peak?
  bool at_peak() const { return peak_.step == last_.step; }

private:
  void take_peak(const fem::StepRecord &record, const fem::Stage &stage);
  void give_pressing(RunSession &session) const;
  void give_end(RunSession &session) const;
  void give_effort(RunSession &session) const;

  double force_floor_;
  fem::StepRecord start_, peak_, last_;
  bool started_ = false, unloaded_ = false, ejecting_ = false, out_ = false;
  fem::Pressing pressing_ = fem::Pressing::upper, peak_by_ = pressing_;
  double residual_wall_pressure_ = 0, unloaded_height_change_ = 0;
  double ejection_force_ = 0, worst_balance_ = 0, worst_energy_ = 0;
  double worst_unbalance_ = 0, worst_hill_mandel_ = 0, worst_asymmetry_ = 0;
  double evaluations_ = 0;
  unsigned steps_ = 0, updates_ = 0, cuts_ = 0, doubtful_steps_ = 0;
  unsigned stagnated_ = 0;
  std::size_t doubtful_points_ = 0;
};
} // namespace tamp::apps

#endif
