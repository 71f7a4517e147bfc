// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_watched_points_h
#define apps_watched_points_h

#include <coupling/unit_cell_points.h>
#include <fem/material_points.h>

namespace tamp::apps
{
/// Passes everything on to other material points and adds up the work of
/// cells, which the model does not know of.
class WatchedPoints final : public fem::MaterialPoints
{
public:
  /// @param cells  the same object as `points`, or null
  WatchedPoints(fem::MaterialPoints &points,
                const coupling::UnitCellPoints *cells)
      : points_(points), cells_(cells)
  {
  }

  std::size_t size() const override { return points_.size(); }
  void begin_attempt() override { points_.begin_attempt(); }
  void evaluate(std::span<const fem::Deformation> deformations,
                fem::Want want,
                std::span<fem::Response> responses) override
  {
    points_.evaluate(deformations, want, responses);
    if (cells_)
      evaluations_ += cells_->report().mean_evaluations;
  }
  void commit() override { points_.commit(); }
  void pack(std::size_t point, std::vector<char> &bytes) const override
  {
    points_.pack(point, bytes);
  }
  void unpack(std::size_t point, std::span<const char> bytes) override
  {
    points_.unpack(point, bytes);
  }
  double cost(std::size_t point) const override { return points_.cost(point); }

  /// Force evaluations per cell since the last call.
  double take_evaluations()
  {
    const double result = evaluations_;
    evaluations_ = 0;
    return result;
  }

private:
  fem::MaterialPoints &points_;
  const coupling::UnitCellPoints *cells_;
  double evaluations_ = 0;
};
} // namespace tamp::apps

#endif
