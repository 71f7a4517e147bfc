// SPDX-License-Identifier: BSD-3-Clause
#include <dem/contacts.h>

namespace tamp::dem
{
namespace
{
void clear(ContactBlock &block)
{
  for (std::size_t lane = 0; lane < ContactBlock::lanes; ++lane) {
    block.first[lane] = block.second[lane] = 0;
    block.radius_sum[lane] = -1;
    block.reduced_radius[lane] = 1;
    block.force_x[lane] = block.force_y[lane] = block.force_z[lane] = 0;
    block.largest_overlap[lane] = block.contact_radius[lane] = 0;
  }
}

void write(ContactBlock &block, std::size_t lane, const ContactMemory &memory)
{
  block.force_x[lane] = memory.tangential_force[0];
  block.force_y[lane] = memory.tangential_force[1];
  block.force_z[lane] = memory.tangential_force[2];
  block.largest_overlap[lane] = memory.largest_overlap;
  block.contact_radius[lane] = memory.contact_radius;
}
} // namespace

void ContactBlocks::lay_out(std::span<const Pair> pairs,
                            std::span<const ContactMemory> memories,
                            std::span<const double> radius)
{
  size_ = pairs.size();
  const std::size_t n = (size_ + ContactBlock::lanes - 1) / ContactBlock::lanes;
  blocks_.resize(n);
  for (ContactBlock &block : blocks_)
    clear(block);

  auto memory = memories.begin();
  for (std::size_t k = 0; k < size_; ++k) {
    ContactBlock &block = blocks_[k % n];
    const std::size_t lane = k / n;
    const Pair pair = pairs[k];
    const double a = radius[pair.first], b = radius[pair.second];
    block.first[lane] = pair.first;
    block.second[lane] = pair.second;
    block.radius_sum[lane] = a + b;
    block.reduced_radius[lane] = a * b / (a + b);
    while (memory != memories.end() && memory->pair < pair)
      ++memory;
    if (memory != memories.end() && memory->pair == pair)
      write(block, lane, *memory);
  }
}

std::vector<ContactMemory> ContactBlocks::memories() const
{
  std::vector<ContactMemory> result;
  const std::size_t n = blocks_.size();
  for (std::size_t k = 0; k < size_; ++k) {
    const ContactBlock &block = blocks_[k % n];
    const std::size_t lane = k / n;
    if (block.largest_overlap[lane] <= 0)
      continue;
    result.push_back(
        {{block.first[lane], block.second[lane]},
         {block.force_x[lane], block.force_y[lane], block.force_z[lane]},
         block.largest_overlap[lane],
         block.contact_radius[lane]});
  }
  return result;
}
} // namespace tamp::dem
