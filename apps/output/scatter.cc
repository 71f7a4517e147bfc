// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/scatter.h>

#include <cmath>

namespace tamp::apps
{
double Scatter::of_mean() const
{
  return count > 0 ? deviation / std::sqrt(static_cast<double>(count)) : 0;
}

Scatter scatter_of(std::span<const double> values)
{
  Scatter scatter;
  scatter.count = values.size();
  const auto count = static_cast<double>(values.size());
  for (const double value : values)
    scatter.mean += value / count;
  for (const double value : values)
    scatter.deviation += std::pow(value - scatter.mean, 2);
  scatter.deviation =
      values.size() > 1 ? std::sqrt(scatter.deviation / (count - 1)) : 0;
  return scatter;
}
} // namespace tamp::apps
