// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_compare_result_folder_h
#define apps_compare_result_folder_h

#include <apps/compare/result_curve.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// A state of a die that its fields.pvd names.
struct WrittenFields {
  unsigned step = 0;
  std::filesystem::path file;
};

/// What a run has left in its folder, finished or not.
struct ResultFolder {
  std::filesystem::path path;
  std::string name; ///< what it is called in tables and plots
  std::string command, status, message;
  std::vector<std::pair<std::string, double>> results; ///< "name[unit]"
  double wall_time = 0, cpu_time = 0;                  ///< [s]
  double ranks = 1, threads = 1;
  ResultCurve curve;
  std::vector<WrittenFields> fields; ///< in their order; may be none

  bool finished() const { return status == "done"; }
  /// A key result; none if the run has no such one.
  std::optional<double> result(const std::string &name) const;
};

/// Throws InputError, before anything else is done, if the folder is not that
/// of a run, run.json lacks what belongs there, or the curve is damaged.
ResultFolder read_result_folder(const std::filesystem::path &path,
                                const std::string &name);
} // namespace tamp::apps

#endif
