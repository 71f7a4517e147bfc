// SPDX-License-Identifier: BSD-3-Clause
#include <fem/path_driver.h>
#include <fem/path_walk.h>

namespace tamp::fem
{
PathEnd drive_path(MaterialPoints &points,
                   const std::vector<PathStage> &stages,
                   const std::function<void(unsigned)> &stage_begins,
                   const std::function<void(const PathRecord &)> &observe,
                   const double stress_tolerance)
{
  PathWalk walk(points, stages, stage_begins, stress_tolerance);
  while (true) {
    if (const auto end = walk.advance())
      return *end;
    if (observe)
      observe(walk.last());
  }
}

PathEnd drive_increments(MaterialPoints &points,
                         const std::vector<dealii::Tensor<2, 3>> &increments,
                         const std::function<void(const PathRecord &)> &observe)
{
  PathStage stage;
  stage.increments = increments;
  return drive_path(points, {stage}, {}, observe);
}
} // namespace tamp::fem
