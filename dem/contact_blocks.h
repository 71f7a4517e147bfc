// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_contact_blocks_h
#define dem_contact_blocks_h

#include <dem/cell_laws.h>
#include <dem/contacts.h>
#include <dem/grains.h>
#include <dem/kernel/contact_block.h>
#include <dem/neighbours.h>

#include <cstddef>
#include <span>
#include <vector>

namespace tamp::dem
{
/// The pairs that a sweep visits, in blocks, T is double or float. Pairs of one
/// kind of materials stand together. With n blocks of a kind, lane l of block b
/// holds pair l n + b of the sorted list: neighbouring pairs of one grain never
/// share a block.
template <class T>
class ContactBlocks
{
public:
  /// The blocks of one kind of pairs.
  struct Group {
    std::size_t kind = 0, first_block = 0, blocks = 0, size = 0;
  };

  /// Lays out `pairs` (sorted), where the grains came by `stretch` and the
  /// motion in `rows`, with the memories of those that have one (sorted,
  /// too, with `more` numbers of the laws' own; memories of other pairs are
  /// left out).
  void lay_out(const CellLaws &laws,
               std::span<const NearPair> pairs,
               std::span<const double> radius,
               std::span<const GrainRow<T>> rows,
               const Matrix3 &stretch,
               std::span<const ContactMemory> memories,
               std::span<const double> more);

  /// The memories of all pairs with a contact radius or an overlap behind
  /// them, sorted, and the laws' own numbers.
  void read_memories(std::vector<ContactMemory> &memories,
                     std::vector<double> &more) const;

  std::span<const Group> groups() const { return groups_; }
  std::span<ContactBlock<T>> blocks() { return blocks_; }
  std::span<const ContactBlock<T>> blocks() const { return blocks_; }
  /// The laws' own numbers: of each block, more_per_contact() rows of lanes.
  std::span<T> more()
  {
    if (more_.empty())
      return {};
    return {more_.front().lane, more_.size() * lanes};
  }
  std::span<const T> more() const
  {
    if (more_.empty())
      return {};
    return {more_.front().lane, more_.size() * lanes};
  }
  std::size_t more_per_contact() const { return more_rows_; }
  std::size_t size() const { return size_; }

  /// Calls visit(block index, lane, near pair) for the pairs that were laid
  /// out.
  template <class Visit>
  void for_each(const CellLaws &laws,
                std::span<const NearPair> pairs,
                Visit &&visit) const
  {
    std::vector<std::size_t> written(groups_.size(), 0);
    for (const NearPair &near : pairs) {
      const std::size_t kind = laws.kind(near.pair);
      const Group &group = groups_[kind];
      const std::size_t k = written[kind]++;
      visit(group.first_block + k % group.blocks, k / group.blocks, near);
    }
  }

private:
  static constexpr std::size_t lanes = ContactBlock<T>::lanes;
  /// A number of every contact of a block, aligned for the widest register.
  struct alignas(64) MoreRow {
    T lane[lanes] = {};
  };

  void write(Pair pair,
             const Vector3 &branch,
             std::span<const double> radius,
             std::size_t block,
             std::size_t lane);

  /// Calls visit(block index, lane) for those that have a memory.
  template <class Visitor>
  void for_each_touching(const Visitor &visit) const;

  std::vector<Group> groups_;
  std::vector<ContactBlock<T>> blocks_;
  std::vector<MoreRow> more_;
  std::size_t more_rows_ = 0, size_ = 0;
};
} // namespace tamp::dem

#endif
