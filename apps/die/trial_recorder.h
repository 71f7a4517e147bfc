// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_trial_recorder_h
#define apps_die_trial_recorder_h

#include <apps/die/recorded_points.h>
#include <apps/output/growing_file.h>
#include <apps/run/run_session.h>
#include <fem/mesh.h>

#include <memory>

namespace tamp::apps
{
/// Keeps what the unit cells of a run are told in a file of its folder,
/// `trials.tamp`, for `tamp inspect`; of continua nothing. If the file cannot
/// be written the run is warned and goes on without.
class TrialRecorder
{
public:
  /// Name of the file.
  static constexpr const char *name = "trials.tamp";

  /// All must outlive the object.
  TrialRecorder(RunSession &session,
                const fem::Mesh &mesh,
                RecordedPoints &points);

  /// Starts the file; or goes on with it as it was at a checkpoint.
  void begin();
  void go_on(fem::StateBytes &stored);
  /// Appends how far the file is, and has it on the disk.
  void pack(std::vector<char> &bytes) const;

  /// Writes what the points were told since the last call, up to the end of a
  /// step or of an attempt at it that failed. Nothing if there was no trial.
  /// Every rank knows the points of all; the first one writes.
  void write(unsigned step, unsigned stage, bool accepted);

private:
  template <class Deed>
  void attempt(const Deed &deed);

  RunSession &session_;
  const fem::Mesh &mesh_;
  RecordedPoints &points_;
  std::unique_ptr<GrowingFile> file_; ///< of the first rank; null: given up
  std::uint64_t steps_ = 0;           ///< in the file
};
} // namespace tamp::apps

#endif
