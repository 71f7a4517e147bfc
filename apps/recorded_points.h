// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_recorded_points_h
#define apps_recorded_points_h

#include <fem/material_points.h>

#include <vector>

namespace tamp::apps
{
/// Passes everything on to other material points and remembers which
/// deformations were committed last, to the last bit: the path of a point can
/// then be replayed.
class RecordedPoints final : public fem::MaterialPoints
{
public:
  explicit RecordedPoints(fem::MaterialPoints &points) : points_(points) {}

  std::size_t size() const override { return points_.size(); }
  void begin_attempt() override { points_.begin_attempt(); }
  void evaluate(std::span<const fem::Deformation> deformations,
                fem::Want want,
                std::span<fem::Response> responses) override
  {
    points_.evaluate(deformations, want, responses);
    trial_.assign(deformations.begin(), deformations.end());
  }
  void commit() override
  {
    points_.commit();
    committed_ = trial_;
  }
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

  /// Of the last committed step, one per point; empty before the first.
  const std::vector<fem::Deformation> &last_deformations() const
  {
    return committed_;
  }

private:
  fem::MaterialPoints &points_;
  std::vector<fem::Deformation> trial_, committed_;
};
} // namespace tamp::apps

#endif
