// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_balanced_shares_h
#define fem_balanced_shares_h

#include <cstddef>
#include <span>
#include <vector>

namespace tamp::fem
{
/// Where the ranges of numbered things begin: part r has begins[r] <= i <
/// begins[r + 1].
using Begins = std::vector<std::size_t>;

/// Parts of equal numbers of `count` things, to one.
Begins equal_shares(std::size_t count, unsigned parts);

/// The ranges whose largest weight is smallest. @param weights  not negative.
Begins balanced_shares(std::span<const double> weights, unsigned parts);

/// The weight of each part.
std::vector<double> loads_of(std::span<const double> weights,
                             std::span<const std::size_t> begins);

/// The share of their time that parts wait for the slowest one: one minus the
/// mean load over the largest; 0 if there is no load.
double idle_share(std::span<const double> loads);
} // namespace tamp::fem

#endif
