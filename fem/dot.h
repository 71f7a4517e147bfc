// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_dot_h
#define fem_dot_h

#include <numeric>
#include <span>

namespace tamp::fem
{
/// Sum of the products of two vectors' entries, in their order.
inline double dot(std::span<const double> a, std::span<const double> b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}
} // namespace tamp::fem

#endif
