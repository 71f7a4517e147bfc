// SPDX-License-Identifier: BSD-3-Clause
#include <fem/opening.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace tamp::fem
{
namespace
{
constexpr double kept_share = 0.3, largest_growth = 2e-3;
/// Where a compact that expands is softest it does so twice as much.
constexpr double concentration = 2;
/// What springs back as a compact leaves the die is well below.
constexpr double largest_growth_of_all = 0.05;

/// What a trial does to a point.
struct Change {
  double before = 0, now = 0; ///< pressures [Pa]
  double growth = 0;          ///< of the volume in the step [-]
  double growth_of_all = 0;   ///< since the point had its room [-]
};

double pressure(const Response &response)
{
  return -dealii::trace(response.stress) / 3;
}

Change change_of(const Compact &compact,
                 const OpeningLimits &limits,
                 std::size_t local)
{
  const Response &now = compact.trial_responses()[local];
  Change result;
  result.before = pressure(compact.state().responses[local]);
  result.now = pressure(now);
  result.growth = compact.volume_ratio(local) - 1;
  if (!limits.densities.empty())
    result.growth_of_all =
        limits.densities[compact.point_share().begin + local] /
            now.relative_density -
        1;
  return result;
}

double growth_limit(const OpeningLimits &limits)
{
  return largest_growth + concentration * limits.parting;
}

/// Losses over what is allowed: the largest; above 1 the point opens.
double excess(const Change &change, const OpeningLimits &limits)
{
  const double left = limits.kept_pressure * change.before;
  double lost = 0;
  if (left > 0 && change.before > limits.least_pressure)
    lost = (left - change.now) / ((1 - kept_share) * left);
  return std::max({lost,
                   change.growth / growth_limit(limits),
                   change.growth_of_all / largest_growth_of_all});
}

std::string sentence(const Change &change, const OpeningLimits &limits)
{
  std::ostringstream text;
  text.precision(3);
  if (change.growth_of_all > largest_growth_of_all)
    text << "has grown by " << 100 * change.growth_of_all
         << " % since the ejection began";
  else if (change.growth > growth_limit(limits))
    text << "grows by " << 100 * change.growth << " % in a step";
  else
    text << "loses its pressure, " << change.before / 1e6
         << " MPa before the step and " << change.now / 1e6 << " MPa after it";
  return text.str();
}
} // namespace

std::optional<Opening> find_opening(const Compact &compact,
                                    const OpeningLimits &limits)
{
  double worst = 1;
  std::size_t found = 0;
  std::vector<double> values(4, 0.);
  for (std::size_t i = 0; i < compact.trial_responses().size(); ++i) {
    const Change change = change_of(compact, limits, i);
    const double now = excess(change, limits);
    if (now <= worst)
      continue;
    worst = now;
    found = compact.point_share().begin + i;
    values = {change.before, change.now, change.growth, change.growth_of_all};
  }
  // The rank with the worst point speaks; the first one of equals.
  const Ranks &ranks = compact.ranks();
  const double of_all = ranks.largest(worst);
  if (of_all <= 1)
    return {};
  const double mine = worst == of_all ? -static_cast<double>(found) : -1e300;
  const auto point = static_cast<std::size_t>(-ranks.largest(mine));
  if (worst != of_all || point != found)
    values.assign(4, 0.);
  ranks.sum(values);
  return Opening{
      point, sentence({values[0], values[1], values[2], values[3]}, limits)};
}
} // namespace tamp::fem
