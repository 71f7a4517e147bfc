// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_trial_file_h
#define apps_die_trial_file_h

#include <coupling/framed_file.h>
#include <fem/material_points.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tamp::apps
{
/// What all points of a die were told at once.
struct PointEvent {
  enum Kind : std::uint64_t {
    turn, ///< the direction of loading turns
    attempt,
    stress, ///< a trial
    stress_and_tangent
  };
  Kind kind = turn;
  double force_floor = 0; ///< of cells after a turn [N]

  bool is_trial() const { return kind == stress || kind == stress_and_tangent; }
};

/// What a point answered to a trial.
struct PointAnswer {
  std::array<double, 6> stress{}; ///< xx, yy, zz, yz, xz, xy, tension positive
                                  ///< [Pa]
  double relative_density = 0;
  bool operator==(const PointAnswer &) const = default;
};
PointAnswer answer_of(const fem::Response &response);

/// All that one point was told from an accepted step to the next one.
struct PointStep {
  unsigned step = 0, stage = 0;
  /// Not so are the start, step 0, and a step that failed, the last one.
  bool accepted = false;
  std::vector<PointEvent> events;
  std::vector<fem::Deformation> trials; ///< of the events that are trials
  PointAnswer answer;                   ///< to the last trial
};

/// What a file of trials is of.
struct TrialTitle {
  std::string program; ///< its version
  std::string input;   ///< see input_in()
  std::uint64_t points = 0, points_per_cell = 1;
};

/// All that the run in a folder is told and that has an effect on its results,
/// as its input.prm says it. Throws coupling::FileError.
std::string input_in(const std::filesystem::path &folder);

/// The trials of all points of a run as they stand in a file: a title, then a
/// frame per step, see coupling::framed(). @return the bytes of the title.
std::vector<char> trial_file_begin(const TrialTitle &title);
/// The bytes of a step.
/// @param head    its trials and answer are not used
/// @param points  what append_point() wrote for each point, in their order
std::vector<char> trial_file_step(std::uint64_t number,
                                  const PointStep &head,
                                  std::span<const char> points);
/// Appends trials and answer of one point to `bytes`.
void append_point(std::vector<char> &bytes,
                  std::span<const fem::Deformation> trials,
                  const PointAnswer &answer);

/// Reads such a file.
class TrialFile
{
public:
  /// Throws coupling::FileError, naming the file, if it cannot be read or is
  /// damaged. What a run that was killed has written half is passed over.
  explicit TrialFile(const std::filesystem::path &file);

  const TrialTitle &title() const { return title_; }
  std::size_t steps() const { return frames_.frames() - 1; }
  /// @param number  in the order of the file, from 0: the start. Throws the
  ///                same.
  PointStep step(std::size_t number, std::size_t point);

private:
  std::vector<char> frame(std::size_t number);

  std::filesystem::path file_;
  coupling::FramedFileReader frames_;
  TrialTitle title_;
};
} // namespace tamp::apps

#endif
