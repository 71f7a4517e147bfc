// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/recorded_points.h>

namespace tamp::apps
{
void RecordedPoints::begin_attempt()
{
  points_.begin_attempt();
  if (cells_)
    events_.push_back({PointEvent::attempt});
}

void RecordedPoints::evaluate(std::span<const fem::Deformation> deformations,
                              fem::Want want,
                              std::span<fem::Response> responses)
{
  points_.evaluate(deformations, want, responses);
  trial_.assign(deformations.begin(), deformations.end());
  if (!cells_)
    return;
  events_.push_back({want == fem::Want::stress
                         ? PointEvent::stress
                         : PointEvent::stress_and_tangent});
  trials_.push_back(trial_);
  answers_.clear();
  for (const fem::Response &response : responses)
    answers_.push_back(answer_of(response));
}

void RecordedPoints::commit()
{
  if (committing_)
    committing_(trial_, answers_);
  points_.commit();
  committed_ = trial_;
}

void RecordedPoints::turn(double force_floor)
{
  if (!cells_)
    return;
  cells_->turn();
  cells_->set_force_floor(force_floor);
  events_.push_back({PointEvent::turn, force_floor});
}

void RecordedPoints::append_points(std::vector<char> &bytes) const
{
  std::vector<fem::Deformation> own(trials_.size());
  for (std::size_t point = 0; point < answers_.size(); ++point) {
    for (std::size_t trial = 0; trial < own.size(); ++trial)
      own[trial] = trials_[trial][point];
    append_point(bytes, own, answers_[point]);
  }
}

void RecordedPoints::forget()
{
  events_.clear();
  trials_.clear();
  answers_.clear();
}
} // namespace tamp::apps
