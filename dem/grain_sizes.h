// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_grain_sizes_h
#define dem_grain_sizes_h

#include <cstdint>
#include <vector>

namespace tamp::dem
{
enum class SizeDistribution { uniform, normal, lognormal };

/// How large grains are. Normal and lognormal distributions are cut off at
/// the minimum and maximum diameter.
struct GrainSizes {
  SizeDistribution distribution = SizeDistribution::uniform;
  double minimum_diameter = 136e-6;  ///< [m]
  double maximum_diameter = 264e-6;  ///< [m]
  double mean_diameter = 200e-6;     ///< [m]; not used by uniform
  double standard_deviation = 30e-6; ///< of the diameter [m]; not used by
                                     ///< uniform

  /// Throws std::invalid_argument naming the first value that is not
  /// possible.
  void check() const;
};

/// Draws `count` radii [m]: the quantiles of the distribution at the middles of
/// `count` equal shares of probability, in an order shuffled by `seed`. Every
/// sample thus has the same sizes, and samples differ by their arrangement
/// only.
std::vector<double>
draw_radii(const GrainSizes &sizes, std::size_t count, std::uint64_t seed);
} // namespace tamp::dem

#endif
