// SPDX-License-Identifier: BSD-3-Clause
#include <dem/kernel/kernel.h>
#include <dem/kernel/sweep.h>

#include <algorithm>

namespace tamp::dem
{
namespace
{
const void *address_of(const auto &law)
{
  return std::visit([](const auto &l) { return static_cast<const void *>(&l); },
                    law);
}

template <class T>
const KernelLoops<T> &loops_of(InstructionSet set)
{
  if constexpr (sizeof(T) == sizeof(double))
    return kernel_of(set).in_double;
  else
    return kernel_of(set).in_float;
}

/// Where memory goes that nobody wants.
template <class T>
struct Scratch {
  static constexpr std::size_t most_more = 32;
  ContactBlock<T> blocks[Chunk<T>::blocks];
  alignas(64) T more[most_more * Chunk<T>::size];
};

template <class T>
AffineLanes<T> lanes_of(const AffineMotion &affine)
{
  AffineLanes<T> result;
  for (int k = 0; k < 9; ++k) {
    result.stretch[k] =
        T(affine.stretch(k / 3, k % 3) - (k / 3 == k % 3 ? 1 : 0));
    result.gradient[k] = T(affine.gradient(k / 3, k % 3));
  }
  return result;
}

/// Where the laws of a kind and their numbers are.
struct KindOfLaws {
  const void *normal, *tangential;
  std::size_t normal_index, tangential_index;
  std::size_t normal_rows; // of the laws' own numbers in a block
};

KindOfLaws kind_of_laws(const PairLaws &laws)
{
  return {address_of(laws.normal),
          address_of(laws.tangential),
          laws.normal.index(),
          laws.tangential.index(),
          laws.normal_more()};
}
} // namespace

template <class T>
SweepTotals sweep(InstructionSet set,
                  const CellLaws &laws,
                  const AffineMotion &affine,
                  SweepRequest request,
                  GrainRows<T> &rows,
                  ContactBlocks<T> &contacts)
{
  const KernelLoops<T> &loops = loops_of<T>(set);
  const AffineLanes<T> lanes = lanes_of<T>(affine);
  const std::size_t more_rows = contacts.more_per_contact();
  const bool frozen = request.memory == Memory::frozen;
  Scratch<T> scratch;
  Chunk<T> chunk;
  double sums[9] = {};
  SweepTotals totals;
  for (GrainRow<T> &row : rows)
    std::fill_n(row.force, 8, T(0));
  for (const auto &group : contacts.groups()) {
    const KindOfLaws kind = kind_of_laws(laws.of_kind(group.kind));
    for (std::size_t b = 0; b < group.blocks; b += Chunk<T>::blocks) {
      const std::size_t at = group.first_block + b;
      ContactBlock<T> *const memory = contacts.blocks().data() + at;
      T *const more =
          contacts.more().data() + at * more_rows * ContactBlock<T>::lanes;
      const ChunkOfBlocks<T> here = {
          std::min(Chunk<T>::blocks, group.blocks - b),
          memory,
          frozen ? scratch.blocks : memory,
          more,
          frozen ? scratch.more : more,
          more_rows};
      KernelTotals<T> part;
      loops.gather(rows.data(), lanes, here, chunk);
      loops.normal[kind.normal_index](kind.normal, here, chunk, part);
      loops.tangential[kind.tangential_index](
          kind.tangential, here.past(kind.normal_rows), chunk, part);
      loops.scatter(here, chunk, rows.data());
      if (request.moment)
        loops.stress(here, chunk, sums);
      totals.normal_force += double(part.normal_force);
      totals.contacts += std::size_t(part.contacts);
      totals.too_deep = totals.too_deep || part.beyond > 0;
      totals.lost_work += double(part.lost_work);
    }
  }
  for (int k = 0; k < 9; ++k)
    totals.moment(k / 3, k % 3) = sums[k];
  return totals;
}

template SweepTotals sweep(InstructionSet,
                           const CellLaws &,
                           const AffineMotion &,
                           SweepRequest,
                           GrainRows<double> &,
                           ContactBlocks<double> &);
template SweepTotals sweep(InstructionSet,
                           const CellLaws &,
                           const AffineMotion &,
                           SweepRequest,
                           GrainRows<float> &,
                           ContactBlocks<float> &);
} // namespace tamp::dem
