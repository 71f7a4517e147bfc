// SPDX-License-Identifier: BSD-3-Clause
#include <dem/contact_blocks.h>

#include <algorithm>
#include <numeric>

namespace tamp::dem
{
namespace
{
/// Fills a block with pairs of the first grain and itself that do not touch.
template <class T>
void clear(ContactBlock<T> &block)
{
  block = {};
  std::ranges::fill(block.branch_x, T(2));
  std::ranges::fill(block.radius_sum, T(1));
  std::ranges::fill(block.inverse_sum, T(1));
  std::ranges::fill(block.overlap, T(-1));
  std::ranges::fill(block.reduced_radius, T(1));
}

/// How many pairs there are of each kind, as groups one after the other.
template <class Group>
std::vector<Group> count_kinds(const CellLaws &laws,
                               std::span<const NearPair> pairs,
                               std::size_t lanes)
{
  std::vector<Group> groups(laws.kinds());
  if (groups.size() == 1)
    groups[0].size = pairs.size();
  else
    for (const NearPair &near : pairs)
      ++groups[laws.kind(near.pair)].size;
  std::size_t first = 0;
  for (std::size_t kind = 0; kind < groups.size(); ++kind) {
    groups[kind].kind = kind;
    groups[kind].first_block = first;
    groups[kind].blocks = (groups[kind].size + lanes - 1) / lanes;
    first += groups[kind].blocks;
  }
  return groups;
}
/// Puts memories of several kinds back into the order of their pairs.
void sort_memories(std::vector<ContactMemory> &memories,
                   std::vector<double> &more,
                   std::size_t rows)
{
  std::vector<std::size_t> order(memories.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::ranges::sort(order, {}, [&](std::size_t k) { return memories[k].pair; });
  std::vector<ContactMemory> sorted;
  std::vector<double> sorted_more;
  sorted.reserve(memories.size());
  sorted_more.reserve(more.size());
  for (std::size_t k : order) {
    sorted.push_back(memories[k]);
    for (std::size_t m = 0; m < rows; ++m)
      sorted_more.push_back(more[k * rows + m]);
  }
  memories = std::move(sorted);
  more = std::move(sorted_more);
}
} // namespace

template <class T>
void ContactBlocks<T>::write(Pair pair,
                             const Vector3 &branch,
                             std::span<const double> radius,
                             std::size_t b,
                             std::size_t lane)
{
  ContactBlock<T> &block = blocks_[b];
  const double ri = radius[pair.first], rj = radius[pair.second];
  block.first[lane] = row_offset<T>(pair.first);
  block.second[lane] = row_offset<T>(pair.second);
  block.branch_x[lane] = T(branch[0]);
  block.branch_y[lane] = T(branch[1]);
  block.branch_z[lane] = T(branch[2]);
  block.overlap[lane] = T(ri + rj - branch.norm());
  block.radius_sum[lane] = T(ri + rj);
  block.inverse_sum[lane] = T(1 / (ri + rj));
  block.reduced_radius[lane] = T(ri * rj / (ri + rj));
}

template <class T>
void ContactBlocks<T>::lay_out(const CellLaws &laws,
                               std::span<const NearPair> pairs,
                               std::span<const double> radius,
                               std::span<const GrainRow<T>> rows,
                               const Matrix3 &stretch,
                               std::span<const ContactMemory> memories,
                               std::span<const double> more)
{
  size_ = pairs.size();
  more_rows_ = laws.more();
  groups_ = count_kinds<Group>(laws, pairs, lanes);
  blocks_.resize(groups_.back().first_block + groups_.back().blocks);
  for (const Group &group : groups_)
    for (std::size_t b = 0; b < group.blocks; ++b)
      clear(blocks_[group.first_block + b]);
  more_.assign(blocks_.size() * more_rows_, {});

  const auto moved = [&](std::uint32_t grain) {
    const T *motion = rows[grain].motion;
    return Vector3(motion[0], motion[1], motion[2]);
  };
  const Matrix3 back = stretch.inverse();
  std::size_t memory = 0;
  for_each(
      laws, pairs, [&](std::size_t b, std::size_t lane, const NearPair &near) {
        const auto [i, j] = near.pair;
        write(near.pair,
              back * (Vector3(near.branch) - (moved(j) - moved(i))),
              radius,
              b,
              lane);
        while (memory < memories.size() && memories[memory].pair < near.pair)
          ++memory;
        if (memory == memories.size() || memories[memory].pair != near.pair)
          return;
        const ContactMemory &known = memories[memory];
        ContactBlock<T> &block = blocks_[b];
        block.force_x[lane] = T(known.tangential_force[0]);
        block.force_y[lane] = T(known.tangential_force[1]);
        block.force_z[lane] = T(known.tangential_force[2]);
        block.largest_overlap[lane] = T(known.largest_overlap);
        block.contact_radius[lane] = T(known.contact_radius);
        for (std::size_t m = 0; m < more_rows_; ++m)
          more_[b * more_rows_ + m].lane[lane] =
              T(more[memory * more_rows_ + m]);
      });
}

template <class T>
template <class Visitor>
void ContactBlocks<T>::for_each_touching(const Visitor &visit) const
{
  for (const Group &group : groups_)
    for (std::size_t k = 0; k < group.size; ++k) {
      const std::size_t b = group.first_block + k % group.blocks;
      const std::size_t lane = k / group.blocks;
      const ContactBlock<T> &block = blocks_[b];
      if (block.largest_overlap[lane] <= 0 && block.contact_radius[lane] <= 0)
        continue;
      visit(b, lane);
    }
}

template <class T>
void ContactBlocks<T>::read_memories(std::vector<ContactMemory> &memories,
                                     std::vector<double> &more) const
{
  memories.clear();
  more.clear();
  // Runs have many cells: none with room that it does not need.
  std::size_t touching = 0;
  for_each_touching([&](std::size_t, std::size_t) { ++touching; });
  memories.reserve(touching);
  more.reserve(touching * more_rows_);
  for_each_touching([&](std::size_t b, std::size_t lane) {
    const ContactBlock<T> &block = blocks_[b];
    memories.push_back(
        {{grain_at<T>(block.first[lane]), grain_at<T>(block.second[lane])},
         {double(block.force_x[lane]),
          double(block.force_y[lane]),
          double(block.force_z[lane])},
         double(block.largest_overlap[lane]),
         double(block.contact_radius[lane])});
    for (std::size_t m = 0; m < more_rows_; ++m)
      more.push_back(double(more_[b * more_rows_ + m].lane[lane]));
  });
  if (groups_.size() > 1)
    sort_memories(memories, more, more_rows_);
}

template class ContactBlocks<double>;
template class ContactBlocks<float>;
} // namespace tamp::dem
