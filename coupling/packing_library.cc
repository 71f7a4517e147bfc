// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/packing_library.h>
#include <coupling/work_sharing.h>
#include <dem/random_numbers.h>

#include <mutex>
#include <numeric>

namespace tamp::coupling
{
std::vector<dem::UnitCell>
make_packings(const dem::PackingRequest &request,
              std::size_t count,
              bool same,
              unsigned threads,
              const std::function<void(std::size_t)> &made,
              std::size_t first)
{
  std::vector<dem::UnitCell> cells(same && count > 0 ? 1 : count);
  std::vector<std::size_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::mutex reporting;
  std::size_t done = 0;
  share_work(order, threads, [&](std::size_t i) {
    dem::PackingRequest mine = request;
    mine.seed = dem::seed_of(request.seed, first + i);
    cells[i] = dem::make_packing(mine);
    const std::lock_guard lock(reporting);
    ++done;
    if (made)
      made(done);
  });
  if (same && count > 0)
    cells.resize(count, cells[0]);
  return cells;
}
} // namespace tamp::coupling
