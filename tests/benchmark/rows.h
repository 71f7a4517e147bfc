// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_benchmark_rows_h
#define tests_benchmark_rows_h

#include <tests/benchmark/packings.h>

#include <benchmark/benchmark.h>
#include <cstddef>
#include <functional>
#include <string>

namespace tamp::speed
{
// A benchmark is a row of benchmark.csv. Its value is its one counter, whose
// name rows.awk turns into a unit.
inline constexpr char particle_steps[] = "particle-steps/s";
inline constexpr char seconds[] = "s";
inline constexpr char evaluations[] = "evaluations";
inline constexpr char relative_error[] = "error";
inline constexpr char efficiency[] = "efficiency";
inline constexpr char bytes[] = "bytes";

/// The end of a row's name that says how many grains there are.
std::string of_grains(std::size_t count);

/// A row of processor time, that of one call over `parts` [s].
benchmark::internal::Benchmark *
add_time(const std::string &name, std::function<void()> call, double parts = 1);

/// A row of a value that is the same each time: one call, no repetitions.
benchmark::internal::Benchmark *add_value(const std::string &name,
                                          const std::string &counter,
                                          std::function<double()> value);

// The rows of dem_benchmark. Packings must outlive their run.
void add_sweeps(Packings &packings);
void add_pair_lists(Packings &packings);
void add_maps(Packings &packings);
void add_tangents(Packings &packings);
void add_bytes(Packings &packings);

/// The rows of coupling_benchmark about continuum laws.
void add_laws();
} // namespace tamp::speed

#endif
