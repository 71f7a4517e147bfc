// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_checkpoints_h
#define apps_run_checkpoints_h

#include <apps/run/run_session.h>
#include <fem/material_points.h>
#include <fem/ranks.h>

#include <chrono>
#include <optional>
#include <span>

namespace tamp::apps
{
/// Writes the checkpoints of a run: from time to time, and when asked to.
class Checkpoints
{
public:
  /// @param session, ranks  must outlive the object.
  Checkpoints(RunSession &session, const fem::Ranks &ranks);

  /// Whether the interval is over or SIGUSR1 came, on any rank. Collective.
  bool due();

  /// Writes one. If that is not possible the run is warned and goes on, with
  /// the checkpoints it has. Collective.
  /// @param state  of the first rank
  void write(unsigned step,
             std::span<const char> state,
             const fem::MaterialPoints &points);

private:
  using Clock = std::chrono::steady_clock;

  RunSession &session_;
  const fem::Ranks &ranks_;
  Clock::time_point last_ = Clock::now();
  std::optional<unsigned> last_step_; ///< of the newest one
  int signals_ = 0;                   ///< SIGUSR1, that were answered
};
} // namespace tamp::apps

#endif
