// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/isotonic.h>

namespace tamp::apps
{
std::vector<IsotonicBlock> isotonic_blocks(std::span<const double> values)
{
  std::vector<IsotonicBlock> blocks;
  for (std::size_t i = 0; i < values.size(); ++i) {
    IsotonicBlock block{i, 1, values[i]};
    while (!blocks.empty() && blocks.back().value >= block.value) {
      const IsotonicBlock &before = blocks.back();
      const double share = static_cast<double>(before.count) /
                           static_cast<double>(before.count + block.count);
      block = {before.first,
               before.count + block.count,
               share * before.value + (1 - share) * block.value};
      blocks.pop_back();
    }
    blocks.push_back(block);
  }
  return blocks;
}

std::vector<double> isotonic(std::span<const double> values)
{
  std::vector<double> result;
  for (const IsotonicBlock &block : isotonic_blocks(values))
    result.insert(result.end(), block.count, block.value);
  return result;
}
} // namespace tamp::apps
