// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_probe_mean_curve_h
#define apps_probe_mean_curve_h

#include <apps/output/number_table.h>

#include <span>
#include <vector>

namespace tamp::apps
{
/// Mean and standard deviation of some numbers; the latter is zero for one.
struct Scatter {
  double mean = 0, deviation = 0;
  std::size_t count = 0;
  double of_mean() const; ///< standard error
};
Scatter scatter_of(std::span<const double> values);

/// The mean of curves of probes: line by line where a stage took all of them as
/// many steps, otherwise at the same shares of the way in strain, as often as
/// the longest one has steps. Behind the columns of the curves stand the
/// standard deviations of stresses and density, "NAME_deviation[unit]". Stages
/// that a curve lacks end the mean. Throws OutputError if columns differ.
NumberTable mean_curve(const std::vector<NumberTable> &curves);
} // namespace tamp::apps

#endif
