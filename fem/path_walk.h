// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_path_walk_h
#define fem_path_walk_h

#include <fem/path_driver.h>
#include <fem/state_bytes.h>
#include <fem/stress_search.h>

#include <functional>
#include <optional>
#include <vector>

namespace tamp::fem
{
/// What drive_path() does, which says how, increment by increment. Between two
/// of them a walk can be stored, together with the point, and gone on with, to
/// the bit.
class PathWalk
{
public:
  /// @param points, stages  must outlive the object; a stage may still be
  ///                        changed when it begins
  PathWalk(MaterialPoints &points,
           const std::vector<PathStage> &stages,
           std::function<void(unsigned)> stage_begins,
           double stress_tolerance);

  /// Evaluates the start (step 0) or takes the next increment: none, and
  /// last() is new; otherwise how the path ended.
  [[nodiscard]] std::optional<PathEnd> advance();

  /// The state after the last advance() that led to one.
  const PathRecord &last() const { return last_; }

  /// Appends all that decides later increments, but for the state of the point.
  void pack(std::vector<char> &bytes) const;
  /// Goes on from what pack() wrote. The stage that has begun must be as it was
  /// then. Throws std::runtime_error if the bytes are those of other stages.
  void unpack(StateBytes &bytes);

private:
  /// All that outlives an increment.
  struct State {
    unsigned step = 0, stage = 0;
    bool started = false; ///< the start has been evaluated
    bool begun = false;   ///< the stage
    bool done = false;    ///< the stage, before its end or at that of its list
    std::size_t next = 0; ///< gradient or increment of the stage to come
    double place = 0;     ///< in the stage or before the next gradient, 0 to 1
    double ahead = 1;     ///< the step that is tried next, of the same
    double nominal = 1, longest = 1, last_step = 0; ///< likewise
    double stress_scale = 0;                        ///< see path::Goal [Pa]
    path::Six strain{}, stress{}, last_increment{};
    path::Six begin_strain{}, end_strain{}, begin_stress{}, end_stress{};
    dealii::Tensor<2, 3> F, begin_F, from_F, rotation;
  };

  const PathStage &stage() const { return stages_[state_.stage]; }
  std::optional<PathEnd> start();
  void begin();
  void aim();
  std::optional<PathEnd> move();
  std::optional<PathEnd> follow_components();
  std::optional<PathEnd> follow_gradients();
  std::optional<PathEnd> follow_increments();
  bool attempt(double place, double step);
  bool refine(double place, double &step);
  bool beyond(const path::Six &stress) const;
  void accept(double step);
  void accept_gradient();
  void report();

  path::Probe probe_;
  const std::vector<PathStage> &stages_;
  std::function<void(unsigned)> stage_begins_;
  double tolerance_;
  State state_;
  PathRecord last_;

  path::Goal goal_; ///< of the stage; strain and stress of the last attempt
  path::Six trial_strain_{}, trial_stress_{};
};
} // namespace tamp::fem

#endif
