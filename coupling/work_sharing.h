// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_work_sharing_h
#define coupling_work_sharing_h

#include <cstddef>
#include <functional>
#include <span>

namespace tamp::coupling
{
/// Calls `work` once for every item of `order`, on `threads` threads that take
/// the next item as they become free: put the longest first. If calls throw,
/// the exception of the first such item in `order` is thrown on when all
/// threads have stopped.
void share_work(std::span<const std::size_t> order,
                unsigned threads,
                const std::function<void(std::size_t)> &work);
} // namespace tamp::coupling

#endif
