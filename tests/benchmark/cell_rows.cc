// SPDX-License-Identifier: BSD-3-Clause
#include <dem/unit_cell_bytes.h>
#include <tests/benchmark/rows.h>

#include <vector>

namespace tamp::speed
{
void add_bytes(Packings &packings)
{
  constexpr double states = 2; // committed and trial
  for (std::size_t count : {200, 1000})
    add_value("cell.bytes" + of_grains(count), bytes, [=, &packings] {
      std::vector<char> image;
      dem::to_bytes(packings.compacted(count), image);
      return states * double(image.size());
    });
}
} // namespace tamp::speed
