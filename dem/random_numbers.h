// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_random_numbers_h
#define dem_random_numbers_h

#include <cstdint>

namespace tamp::dem
{
/// A good 64-bit mix of its argument: seeds by identity.
/// Source: Steele, Lea & Flood (2014), OOPSLA: SplitMix64.
constexpr std::uint64_t mixed(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

/// The seed of one of many samples of a run.
constexpr std::uint64_t seed_of(std::uint64_t run, std::uint64_t sample)
{
  return mixed(mixed(run) ^ (sample + 1));
}

/// Random numbers that are the same on every machine and library.
class RandomNumbers
{
public:
  explicit constexpr RandomNumbers(std::uint64_t seed) : state_(seed) {}
  /// Uniform in [0, 1).
  constexpr double next()
  {
    state_ += 0x9e3779b97f4a7c15;
    return double(mixed(state_) >> 11) * 0x1p-53;
  }

private:
  std::uint64_t state_;
};
} // namespace tamp::dem

#endif
