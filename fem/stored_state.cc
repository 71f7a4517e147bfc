// SPDX-License-Identifier: BSD-3-Clause
#include <fem/press.h>
#include <fem/schedule.h>

#include <cstddef>
#include <stdexcept>
#include <string>

// All that decides later steps, and nothing that follows from it. Whoever adds
// a member that outlives a step adds it here.
namespace tamp::fem
{

namespace
{
/// Values of all ranks' points, on the first rank.
template <class Value>
std::vector<Value> of_all_ranks(const std::vector<Value> &own,
                                const Ranks &ranks)
{
  std::vector<Value> all;
  for (unsigned rank = 0; rank < ranks.size(); ++rank) {
    std::vector<char> bytes;
    if (rank == ranks.rank())
      append_state(bytes, own);
    ranks.move(bytes, rank, 0);
    if (ranks.rank() != 0)
      continue;
    std::vector<Value> part;
    StateBytes(bytes).take(part);
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

template <class Value>
std::vector<Value>
take_share(StateBytes &bytes, std::size_t count, const Share &share)
{
  std::vector<Value> all;
  bytes.take(all);
  if (all.size() != count)
    throw std::runtime_error(
        "the stored compact has " + std::to_string(all.size()) +
        " nodes or points where the mesh has " + std::to_string(count));
  return {all.begin() + static_cast<std::ptrdiff_t>(share.begin),
          all.begin() + static_cast<std::ptrdiff_t>(share.end)};
}
} // namespace

void Compact::pack(std::vector<char> &bytes) const
{
  append_state(bytes, state_.positions);
  append_state(bytes, of_all_ranks(state_.responses, ranks_));
  append_state(bytes, of_all_ranks(state_.deformation_gradients, ranks_));
}

void Compact::unpack(StateBytes &bytes)
{
  const std::size_t nodes = mesh_.nodes.size(),
                    points = mesh_.number_of_points();
  state_.positions = take_share<dealii::Tensor<1, 3>>(bytes, nodes, {0, nodes});
  state_.responses = take_share<Response>(bytes, points, point_share());
  state_.deformation_gradients =
      take_share<dealii::Tensor<2, 3>>(bytes, points, point_share());
  update_geometry(state_.positions, committed_, committed_centres_);
}

template <class Self, class Use>
void ToolContact::each_part(Self &self, const Use &use)
{
  use(self.accepted_);
  use(self.released_);
  use(self.at_release_);
  use(self.release_heights_);
}

void ToolContact::pack(std::vector<char> &bytes) const
{
  each_part(*this, [&](const auto &part) { append_state(bytes, part); });
}

void ToolContact::unpack(StateBytes &bytes, const NodePositions &positions)
{
  each_part(*this, [&](auto &part) {
    bytes.take(part);
    if (part.size() != pairs_.size())
      throw std::runtime_error("the stored contacts are those of other tools");
  });
  update_areas(positions);
}

template <class Self, class Use>
void Press::each_part(Self &self, const Use &use)
{
  use(self.tools_);
  use(self.forces_);
  use(self.work_);
  use(self.peak_reactions_);
  use(self.times_);
}

void Press::pack(std::vector<char> &bytes) const
{
  compact_.pack(bytes);
  contact_.pack(bytes);
  each_part(*this, [&](const auto &part) { append_state(bytes, part); });
}

void Press::unpack(StateBytes &bytes)
{
  compact_.unpack(bytes);
  contact_.unpack(bytes, compact_.state().positions);
  each_part(*this, [&](auto &part) { bytes.take(part); });
  pair_forces_ = contact_.accepted();
  trial_tools_ = tools_;
}

template <class Self, class Use>
void Schedule::each_part(Self &self, const Use &use)
{
  use(self.stage_);
  use(self.phase_count_);
  use(self.phase_);
  use(self.pressing_);
  use(self.movers_);
  use(self.step_);
  use(self.begin_);
  use(self.first_remaining_);
  use(self.target_force_);
  use(self.direction_);
  use(self.slope_);
  use(self.volume_slope_);
  use(self.last_driving_);
  use(self.before_);
  use(self.after_);
  use(self.steps_done_);
  use(self.landed_);
}

void Schedule::pack(std::vector<char> &bytes) const
{
  each_part(*this, [&](const auto &part) { append_state(bytes, part); });
}

void Schedule::unpack(StateBytes &bytes)
{
  each_part(*this, [&](auto &part) { bytes.take(part); });
}
} // namespace tamp::fem
