// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_calibration_file_h
#define apps_calibrate_calibration_file_h

#include <apps/calibrate/fit_parameter.h>
#include <apps/output/curve_writer.h>

#include <Eigen/Dense>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tamp::apps
{
/// What a run is made for.
enum class RunKind {
  survey = 1, ///< of all places between the bounds
  refinement, ///< of the search, with what it learnt
  packings    ///< several packings instead of one, at the end
};

/// A run of a calibration.
struct CalibrationRun {
  RunKind kind = RunKind::survey;
  unsigned packing = 0;       ///< 0: that of the search
  std::vector<double> values; ///< of the parameters, in SI
  Eigen::VectorXd residuals;  ///< none: the run failed
};

/// `calibration.csv`: a line per run, in their order. A calibration that is
/// resumed takes from it what was computed before.
class CalibrationFile
{
public:
  /// What earlier runs a file has, if there is one: nothing is changed. Throws
  /// InputError if it is that of other remarks, parameters or number of
  /// residuals. A last line that was cut off is passed over.
  CalibrationFile(const std::filesystem::path &file,
                  const std::vector<std::string> &remarks,
                  const std::vector<FitParameter> &parameters);

  /// Opens the file for writing: goes on behind the runs that it has, or
  /// begins it anew. Throws OutputError. `residuals`: their number.
  void open(std::size_t residuals);

  /// The run of this number, if it was made before. Throws InputError if it
  /// was made at other values or had another number of residuals.
  std::optional<CalibrationRun> stored(std::size_t number,
                                       const std::vector<double> &values) const;
  std::size_t stored() const { return runs_.size(); }

  /// Appends the next run. Throws OutputError.
  void write(const CalibrationRun &run);

private:
  void read();
  std::vector<std::string> header(std::size_t residuals) const;

  std::filesystem::path file_;
  std::vector<std::string> remarks_;
  std::vector<FitParameter> parameters_;
  std::vector<CalibrationRun> runs_;
  std::size_t residuals_ = 0;
  std::uint64_t size_ = 0; ///< of the file up to the last whole line
  std::unique_ptr<CurveWriter> writer_;
  std::size_t written_ = 0;
};
} // namespace tamp::apps

#endif
