// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_calibrate_h
#define apps_calibrate_calibrate_h

#include <apps/run/run_session.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tamp::apps
{
/// What a user says of a calibration besides what every run is told.
struct CalibrationChoice {
  std::filesystem::path data;
  std::vector<std::string> fits;
  std::string model = "probe"; ///< or "die"
  std::size_t most_runs =
      0;                 ///< of the search; 0: 20 for each parameter, and 20
  unsigned packings = 7; ///< of unit cells, at the end; a probe only
  /// See CurveReference; empty: not said.
  std::string density_at_start, height_at_start, area;
};

/// Looks for the values of parameters with which a probe or a die follows a
/// measured curve best. Returns the program's exit code; throws InputError or
/// OutputError.
int calibrate(const CalibrationChoice &choice, const RunOptions &options);
} // namespace tamp::apps

#endif
