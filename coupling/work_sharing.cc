// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/work_sharing.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace tamp::coupling
{
void share_work(std::span<const std::size_t> order,
                unsigned threads,
                const std::function<void(std::size_t)> &work)
{
  std::atomic<std::size_t> next = 0;
  std::vector<std::exception_ptr> errors(order.size());
  const auto take_items = [&] {
    for (std::size_t k = next++; k < order.size(); k = next++)
      try {
        work(order[k]);
      } catch (...) {
        errors[k] = std::current_exception();
      }
  };
  {
    const std::size_t extra =
        std::min<std::size_t>(std::max(threads, 1u), order.size());
    std::vector<std::jthread> crew;
    for (std::size_t t = 1; t < extra; ++t)
      crew.emplace_back(take_items);
    take_items();
  }
  for (const std::exception_ptr &error : errors)
    if (error)
      std::rethrow_exception(error);
}
} // namespace tamp::coupling
