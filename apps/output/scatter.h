// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_output_scatter_h
#define apps_output_scatter_h

#include <cstddef>
#include <span>

namespace tamp::apps
{
/// Mean and standard deviation of some numbers; the latter is zero for one.
struct Scatter {
  double mean = 0, deviation = 0;
  std::size_t count = 0;
  double of_mean() const; ///< standard error
};
Scatter scatter_of(std::span<const double> values);
} // namespace tamp::apps

#endif
