// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_recorded_points_h
#define apps_die_recorded_points_h

#include <apps/die/trial_file.h>
#include <coupling/shared_cells.h>

#include <functional>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// Passes everything on to other material points and remembers, to the last
/// bit, which deformations were committed last and, of unit cells, all that
/// they were told since forget(): what a point went through can be replayed.
class RecordedPoints final : public fem::MaterialPoints
{
public:
  /// @param cells  the same points if they are unit cells, otherwise null
  RecordedPoints(fem::MaterialPoints &points, coupling::SharedCells *cells)
      : points_(points), cells_(cells)
  {
  }

  std::size_t size() const override { return points_.size(); }
  void begin_attempt() override;
  void evaluate(std::span<const fem::Deformation> deformations,
                fem::Want want,
                std::span<fem::Response> responses) override;
  void commit() override;
  void pack(std::size_t point, std::vector<char> &bytes) const override
  {
    points_.pack(point, bytes);
  }
  void unpack(std::size_t point, std::span<const char> bytes) override
  {
    points_.unpack(point, bytes);
  }
  double cost(std::size_t point) const override { return points_.cost(point); }
  std::vector<fem::Variable> variables() const override
  {
    return points_.variables();
  }
  void variables_of(std::size_t point, std::span<double> values) const override
  {
    points_.variables_of(point, values);
  }

  /// Is called with the deformations that are about to be committed, and what
  /// unit cells answered to them.
  using Committing = std::function<void(std::span<const fem::Deformation>,
                                        std::span<const PointAnswer>)>;
  void when_committing(Committing deed) { committing_ = std::move(deed); }

  /// The direction of loading turns, see UnitCellPoints::turn() and
  /// set_force_floor() [N]. Continua need not know.
  void turn(double force_floor);

  /// Of the last committed step, one per point; empty before the first.
  const std::vector<fem::Deformation> &last_deformations() const
  {
    return committed_;
  }

  bool are_cells() const { return cells_ != nullptr; }
  /// What unit cells were told since forget().
  const std::vector<PointEvent> &events() const { return events_; }
  /// Appends their trials and last answers, point after point.
  void append_points(std::vector<char> &bytes) const;
  void forget();

private:
  fem::MaterialPoints &points_;
  coupling::SharedCells *cells_;
  std::vector<fem::Deformation> trial_, committed_;
  std::vector<PointEvent> events_;
  std::vector<std::vector<fem::Deformation>> trials_; ///< each of all points
  std::vector<PointAnswer> answers_;                  ///< to the last trial
  Committing committing_;
};
} // namespace tamp::apps

#endif
