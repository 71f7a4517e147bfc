// SPDX-License-Identifier: BSD-3-Clause
#include <fem/balanced_shares.h>

#include <algorithm>
#include <numeric>

namespace tamp::fem
{
namespace
{
/// Fills one part after the other up to `most`; the last takes what is left.
Begins filled(std::span<const double> weights, unsigned parts, double most)
{
  Begins begins{0};
  double load = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (load + weights[i] > most && begins.size() < parts) {
      begins.push_back(i);
      load = 0;
    }
    load += weights[i];
  }
  begins.resize(parts + 1, weights.size());
  return begins;
}

double largest_load(std::span<const double> weights, const Begins &begins)
{
  const auto loads = loads_of(weights, begins);
  return *std::max_element(loads.begin(), loads.end());
}
} // namespace

Begins equal_shares(std::size_t count, unsigned parts)
{
  Begins begins;
  for (unsigned part = 0; part <= parts; ++part)
    begins.push_back(count * part / parts);
  return begins;
}

Begins balanced_shares(std::span<const double> weights, unsigned parts)
{
  // The smallest load up to which all fits is found by bisection between two
  // that are never and always enough.
  const double all = std::accumulate(weights.begin(), weights.end(), 0.);
  double few = all / parts * (1 - 1e-12), enough = all;
  Begins best = filled(weights, parts, enough);
  while (enough - few > 1e-9 * all) {
    const double most = 0.5 * (few + enough);
    const Begins trial = filled(weights, parts, most);
    const double load = largest_load(weights, trial);
    if (load > most) {
      few = most;
      continue;
    }
    enough = load;
    best = trial;
  }
  return best;
}

std::vector<double> loads_of(std::span<const double> weights,
                             std::span<const std::size_t> begins)
{
  std::vector<double> loads;
  for (std::size_t part = 0; part + 1 < begins.size(); ++part) {
    const auto own =
        weights.subspan(begins[part], begins[part + 1] - begins[part]);
    loads.push_back(std::accumulate(own.begin(), own.end(), 0.));
  }
  return loads;
}

double idle_share(std::span<const double> loads)
{
  const double most = *std::max_element(loads.begin(), loads.end());
  const double all = std::accumulate(loads.begin(), loads.end(), 0.);
  return most > 0 ? 1 - all / static_cast<double>(loads.size()) / most : 0;
}
} // namespace tamp::fem
