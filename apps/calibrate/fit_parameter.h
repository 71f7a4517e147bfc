// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_fit_parameter_h
#define apps_calibrate_fit_parameter_h

#include <apps/run/run_session.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// An entry of the input that is looked for between two bounds. Its place is 0
/// at the lower one and 1 at the upper one; in between it is linear in the
/// value or, where the bounds are positive and a decade or more apart, in its
/// logarithm.
struct FitParameter {
  std::string path;         ///< "Section/Name"
  std::string unit;         ///< of SI, "-" if it has none
  double low = 0, high = 1; ///< in SI
  bool logarithmic = false;

  double value(double place) const;
  /// d value / d place.
  double slope(double place) const;
  /// "Section/Name = value" in SI, to the last bit.
  std::string setting(double place) const;
  /// What was said after --fit, in SI.
  std::string words() const;
};

/// Reads what was said after --fit: "Section/Name = LOW .. HIGH", with units as
/// in an input. Throws InputError if there is no such entry in the table of the
/// input, if it is no number that may take all values between the bounds, if
/// two are the same, or if it is one that the calibration keeps: those that
/// make packings, the path and the schedule.
std::vector<FitParameter>
read_fit_parameters(const std::vector<std::string> &texts,
                    const RunOptions &options);
} // namespace tamp::apps

#endif
