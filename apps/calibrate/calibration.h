// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_calibration_h
#define apps_calibrate_calibration_h

#include <apps/calibrate/calibration_file.h>
#include <apps/calibrate/curve_simulator.h>
#include <apps/calibrate/curve_targets.h>
#include <apps/calibrate/fit_parameter.h>
#include <apps/calibrate/surrogate_search.h>
#include <apps/run/run_session.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tamp::apps
{
/// Where a run is made: its parameters between their bounds, and its packing.
struct CalibrationPlace {
  Eigen::VectorXd place;
  unsigned packing = 0;
};

/// The input of a run with values of its parameters: that of the command, with
/// what all runs share, such as their packing, and with the values.
struct CalibrationInput {
  RunOptions options; ///< the input and its --set
  std::vector<FitParameter> parameters;
  std::vector<std::string> shared; ///< settings
  Need need = Need::probe;

  /// Settings of each packing besides those, if there are several.
  std::vector<std::vector<std::string>> of_packing;

  /// With all settings; throws InputError if values do not fit together.
  RunInput at(const CalibrationPlace &place) const;
  /// With the values that the input has.
  RunInput base(unsigned packing = 0) const;
  /// A complete input file with the values of a place and packings from
  /// `packings`, unless that is empty.
  std::string echo(const Eigen::VectorXd &place,
                   const std::string &packings) const;
  std::vector<double> values(const Eigen::VectorXd &place) const;

private:
  RunInput read(const std::vector<std::string> &values) const;
};

/// Makes the runs that a search asks for, several at a time, and keeps each of
/// them in the file; those that the file has are not made again.
class CalibrationRuns
{
public:
  /// All must outlive this.
  CalibrationRuns(RunSession &session,
                  const CalibrationInput &input,
                  const CurveSimulator &simulator,
                  const CurveTargets &targets,
                  CalibrationFile &file,
                  std::size_t most_runs);

  /// See EvaluatePlaces. Throws SimulationInterrupted after a signal, when the
  /// runs that had ended are in the file; std::runtime_error if all have
  /// failed.
  std::vector<Eigen::VectorXd>
  evaluate(const std::vector<CalibrationPlace> &places, RunKind kind);

  std::size_t runs() const { return runs_; }
  std::size_t failed() const { return failed_; }

private:
  struct Batch;
  void make(Batch &batch, std::size_t k);
  void write(Batch &batch);
  void say(const CalibrationRun &run, const std::string &problem);

  RunSession &session_;
  const CalibrationInput &input_;
  const CurveSimulator &simulator_;
  const CurveTargets &targets_;
  CalibrationFile &file_;
  std::size_t most_runs_;
  std::size_t runs_ = 0; ///< in the file, of this calibration
  std::size_t failed_ = 0;
  double best_ = 0; ///< misfit so far; 0: none
};
} // namespace tamp::apps

#endif
