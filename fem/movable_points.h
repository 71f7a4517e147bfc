// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_movable_points_h
#define fem_movable_points_h

#include <fem/material_points.h>
#include <fem/ranks.h>

namespace tamp::fem
{
/// Material points that are a range of all points of a run, and can become
/// another one: their states can move from rank to rank.
class MovablePoints : public MaterialPoints
{
public:
  /// Which of all points these are.
  virtual Share share() const = 0;

  /// Becomes another range. Points of both ranges keep their committed states;
  /// those that are new have none until unpack() brings it.
  virtual void hold(const Share &share) = 0;
};
} // namespace tamp::fem

#endif
