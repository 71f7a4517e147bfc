// SPDX-License-Identifier: BSD-3-Clause
#include <tests/benchmark/rows.h>

#include <utility>

namespace tamp::speed
{
std::string of_grains(std::size_t count)
{
  return '.' + std::to_string(count);
}

benchmark::internal::Benchmark *
add_time(const std::string &name, std::function<void()> call, double parts)
{
  using benchmark::Counter;
  const auto measure = [call = std::move(call),
                        parts](benchmark::State &state) {
    call(); // what is made once is made before the clock runs
    for (auto _ : state)
      call();
    state.counters[seconds] =
        Counter(parts, Counter::kIsIterationInvariantRate | Counter::kInvert);
  };
  return benchmark::RegisterBenchmark(name.c_str(), measure)
      ->Unit(benchmark::kMicrosecond);
}

benchmark::internal::Benchmark *add_value(const std::string &name,
                                          const std::string &counter,
                                          std::function<double()> value)
{
  const auto measure = [counter,
                        value = std::move(value)](benchmark::State &state) {
    for (auto _ : state)
      state.counters[counter] = value();
  };
  return benchmark::RegisterBenchmark(name.c_str(), measure)
      ->Iterations(1)
      ->Repetitions(1)
      ->Unit(benchmark::kMillisecond);
}
} // namespace tamp::speed
