// SPDX-License-Identifier: BSD-3-Clause
#include <dem/grain_sizes.h>
#include <dem/random_numbers.h>
#include <dem/size_table.h>
#include <dem/value_check.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace tamp::dem
{
namespace
{
double normal_share(double x)
{
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

/// x in [low, high] with share(x) = wanted; share rises.
double solve(const std::function<double(double)> &share,
             double wanted,
             double low,
             double high)
{
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (share(middle) < wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The share of grains (not of mass) below a diameter, before the cut-off.
std::function<double(double)> cumulative(const GrainSizes &sizes)
{
  const double m = sizes.mean_diameter, s = sizes.standard_deviation;
  if (sizes.distribution == SizeDistribution::normal)
    return [m, s](double d) { return normal_share((d - m) / s); };
  // Mean m and deviation s of the diameter itself.
  const double v = std::log1p(s * s / (m * m));
  return [m, v](double d) {
    return normal_share((std::log(d / m) + v / 2) / std::sqrt(v));
  };
}

/// The diameter below which `part` of a `whole` number of grains lie.
using Quantile = std::function<double(double part, double whole)>;

Quantile quantiles(const GrainSizes &sizes)
{
  if (sizes.distribution == SizeDistribution::table)
    return [table = SizeTable(sizes.table, sizes.basis)](double part,
                                                         double whole) {
      return table.quantile(part / whole);
    };
  const double low = sizes.minimum_diameter, high = sizes.maximum_diameter;
  if (sizes.distribution == SizeDistribution::uniform || low == high)
    return [low, high](double part, double whole) {
      return low + (high - low) * part / whole;
    };
  const auto below = cumulative(sizes);
  const double first = below(low), inside = below(high) - first;
  return [=](double part, double whole) {
    return solve(below, first + inside * part / whole, low, high);
  };
}
} // namespace

void GrainSizes::check() const
{
  if (distribution == SizeDistribution::table) {
    (void)SizeTable(table, basis);
    return;
  }
  Positive{}(minimum_diameter, "minimum diameter");
  if (!(maximum_diameter >= minimum_diameter))
    refuse(
        "maximum diameter", maximum_diameter, "at least the minimum diameter");
  if (distribution == SizeDistribution::uniform)
    return;
  Positive{}(standard_deviation, "standard deviation of the diameter");
  if (!(mean_diameter >= minimum_diameter && mean_diameter <= maximum_diameter))
    refuse("mean diameter",
           mean_diameter,
           "between the minimum and the maximum diameter");
}

std::vector<double>
draw_radii(const GrainSizes &sizes, std::size_t count, std::uint64_t seed)
{
  sizes.check();
  const auto quantile = quantiles(sizes);
  std::vector<double> radius(count);
  for (std::size_t k = 0; k < count; ++k)
    radius[k] = 0.5 * quantile(double(k) + 0.5, double(count));
  RandomNumbers random(seed);
  for (std::size_t k = count; k > 1; --k)
    std::swap(radius[k - 1], radius[std::size_t(random.next() * double(k))]);
  return radius;
}
} // namespace tamp::dem
