// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_inspected_run_h
#define apps_die_inspected_run_h

#include <apps/die/trial_file.h>

#include <filesystem>
#include <optional>
#include <string>

namespace tamp::apps
{
/// Which point of which run, and when.
struct PointChoice {
  std::filesystem::path folder; ///< of the run
  std::optional<long> cell;     ///< of the mesh
  long point = 0; ///< among all points or, with `cell`, among those of the cell
  std::string step; ///< a number, "all", or empty: the last one
};

/// A die's run as it lies in its folder, finished or not, with what its unit
/// cells were told.
class InspectedRun
{
public:
  /// Throws InputError if the folder is not that of such a run or the point is
  /// not one of it, FileError of coupling if what was recorded cannot be read.
  explicit InspectedRun(const PointChoice &choice);

  std::filesystem::path input() const { return folder_ / "input.prm"; }
  std::size_t cell() const { return point_ / trials_->title().points_per_cell; }
  /// Among all points of the mesh.
  std::size_t point() const { return point_; }
  /// The recorded steps, the start first.
  std::size_t steps() const { return trials_->steps(); }
  PointStep step(std::size_t number) { return trials_->step(number, point_); }
  std::size_t last_accepted() const { return last_accepted_; }
  const TrialTitle &title() const { return trials_->title(); }

  /// Are the grains of this step wanted?
  bool wants(unsigned step) const { return !wanted_ || *wanted_ == step; }

private:
  void find_point(const PointChoice &choice);
  void find_step(const PointChoice &choice);

  std::filesystem::path folder_;
  std::optional<TrialFile> trials_;
  std::size_t point_ = 0, last_accepted_ = 0;
  std::optional<unsigned> wanted_; ///< none: all
};
} // namespace tamp::apps

#endif
