// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/adhesive_yield.h>
#include <dem/value_check.h>

#include <cmath>
#include <sstream>

namespace tamp::dem
{
namespace
{
using std::numbers::pi;
constexpr double least_ratio = 0.425; // p_y / p_a, from 0.42480
} // namespace

double AdhesiveYield::least_pressure(double effective_modulus,
                                     double work_of_adhesion,
                                     double radius)
{
  return least_ratio * std::cbrt(2 * effective_modulus * effective_modulus *
                                 work_of_adhesion / (pi * pi * radius));
}

void AdhesiveYield::check(double radius) const
{
  const double pressure = 2 * effective_modulus_ * limit_ / pi;
  const double adhesion = elastic_.pull_off(1.0) / (1.5 * pi);
  const double least = least_pressure(effective_modulus_, adhesion, radius);
  if (pressure >= least)
    return;
  std::ostringstream expected;
  expected << "at least " << least << " Pa with a work of adhesion of "
           << adhesion << " J/m2 and a reduced radius of " << radius
           << " m; below, contacts that yield and adhere would give energy "
              "away";
  refuse("limiting contact pressure", pressure, expected.str());
}
} // namespace tamp::dem
