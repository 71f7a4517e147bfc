// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_grain_sizes_h
#define dem_grain_sizes_h

#include <cstdint>
#include <vector>

namespace tamp::dem
{
enum class SizeDistribution { uniform, normal, lognormal, table };

/// What a share is a share of: the number of the grains or their volume (that
/// is their mass, grains of one solid).
enum class ShareBasis { number, volume };

/// A line of a measured distribution: the share of grains below a diameter.
struct SizeShare {
  double diameter = 0; ///< [m]
  double below = 0;    ///< share of all grains that is smaller, 0 to 1 [-]
  bool operator==(const SizeShare &) const = default;
};

/// How large grains are. Normal and lognormal distributions, by number, are cut
/// off at the minimum and maximum diameter. A table rises from a share of 0 to
/// a share of 1 and is linear between its lines; two lines of one diameter are
/// a class of equal grains. It alone decides the sizes then.
struct GrainSizes {
  SizeDistribution distribution = SizeDistribution::uniform;
  double minimum_diameter = 136e-6;      ///< [m]
  double maximum_diameter = 264e-6;      ///< [m]
  double mean_diameter = 200e-6;         ///< [m]; normal and lognormal only
  double standard_deviation = 30e-6;     ///< of the diameter [m]; normal and
                                         ///< lognormal only
  std::vector<SizeShare> table;          ///< table only
  ShareBasis basis = ShareBasis::number; ///< of the table

  /// Throws std::invalid_argument naming the first value that is not
  /// possible.
  void check() const;
  bool operator==(const GrainSizes &) const = default;
};

/// Draws `count` radii [m]: the quantiles of the distribution by number at the
/// middles of `count` equal shares of probability, in an order shuffled by
/// `seed`. Every sample thus has the same sizes, and samples differ by their
/// arrangement only.
std::vector<double>
draw_radii(const GrainSizes &sizes, std::size_t count, std::uint64_t seed);
} // namespace tamp::dem

#endif
