// SPDX-License-Identifier: BSD-3-Clause
#include <fem/compact.h>
#include <fem/density_range.h>

#include <algorithm>
#include <limits>

namespace tamp::fem
{
DensityRange density_range(const Compact &compact)
{
  const auto &responses = compact.state().responses;
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  std::vector<double> sums{0, 0}; // mass, volume
  for (std::size_t i = 0; i < responses.size(); ++i) {
    const double density = responses[i].relative_density;
    const double volume = compact.geometry()[i].volume;
    sums[0] += density * volume;
    sums[1] += volume;
    smallest = std::min(smallest, density);
    largest = std::max(largest, density);
  }
  compact.ranks().sum(sums);
  return {sums[0] / sums[1],
          -compact.ranks().largest(-smallest),
          compact.ranks().largest(largest)};
}

std::vector<double> relative_densities(const Compact &compact)
{
  std::vector<double> result;
  for (const Response &response : compact.state().responses)
    result.push_back(response.relative_density);
  return compact.whole(result);
}
} // namespace tamp::fem
