// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_stop_watch_h
#define fem_stop_watch_h

#include <chrono>

namespace tamp::fem
{
/// Adds the time of its life to a sum [s].
class StopWatch
{
public:
  explicit StopWatch(double &sum) : sum_(sum), start_(Clock::now()) {}
  ~StopWatch()
  {
    sum_ += std::chrono::duration<double>(Clock::now() - start_).count();
  }
  StopWatch(const StopWatch &) = delete;
  StopWatch &operator=(const StopWatch &) = delete;

private:
  using Clock = std::chrono::steady_clock;
  double &sum_;
  Clock::time_point start_;
};
} // namespace tamp::fem

#endif
