// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_isotonic_h
#define apps_fit_isotonic_h

#include <cstddef>
#include <span>
#include <vector>

namespace tamp::apps
{
/// Neighbours that have one value in a sequence that does not fall.
struct IsotonicBlock {
  std::size_t first = 0, count = 0; ///< which of the given values
  double value = 0;                 ///< their mean
};

/// The sequence that does not fall and is nearest to the given one, by the sum
/// of squared differences: blocks whose values rise. Source: pool adjacent
/// violators, R. E. Barlow et al., Statistical Inference under Order
/// Restrictions (1972), ch. 1.
std::vector<IsotonicBlock> isotonic_blocks(std::span<const double> values);

/// The same, one number for each given one.
std::vector<double> isotonic(std::span<const double> values);
} // namespace tamp::apps

#endif
