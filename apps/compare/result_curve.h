// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_compare_result_curve_h
#define apps_compare_result_curve_h

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// The lines of one stage of a curve, [first, last]. It begins with the last
/// line of the stage before it, from which it starts.
struct StageLines {
  unsigned stage = 1; ///< stages count from 1
  std::size_t first = 0, last = 0;
};

/// A curve.csv as a run has left it: columns by name, and its stages.
class ResultCurve
{
public:
  /// No lines.
  ResultCurve() = default;
  /// Throws InputError, "FILE:LINE: ...", if there is no such file, no header,
  /// no line of values, or a line that has not a number for each name.
  explicit ResultCurve(const std::filesystem::path &file);

  /// Number of lines.
  std::size_t size() const { return size_; }
  bool has(const std::string &name) const { return columns_.contains(name); }
  /// Throws InputError naming the file if there is no such column.
  const std::vector<double> &column(const std::string &name) const;
  /// Adds a column of as many values as there are lines.
  void add(const std::string &name, std::vector<double> values);

  /// In their order: stages, packings of a pack, or all lines as one stage.
  const std::vector<StageLines> &stages() const { return stages_; }
  /// The first word of what the file says of a stage: "press", "unload";
  /// empty if it says nothing.
  std::string kind(unsigned stage) const;

private:
  void take_remark(const std::string &remark);
  void find_stages();

  std::filesystem::path file_;
  std::size_t size_ = 0;
  std::map<std::string, std::vector<double>> columns_;
  std::map<unsigned, std::string> kinds_;
  std::vector<StageLines> stages_;
};
} // namespace tamp::apps

#endif
