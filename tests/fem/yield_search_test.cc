// SPDX-License-Identifier: BSD-3-Clause
#include <fem/yield_search.h>

#include <cmath>
#include <gtest/gtest.h>

namespace tamp::fem
{
namespace
{
constexpr double pressure = 1e6, largest = 1.2e6; ///< p and the peak of q [Pa]
constexpr double shear_at_peak = 0.08;
/// A modulus so large that nothing but plastic strain counts [Pa].
constexpr double rigid = 1e15;

/// Axial compression at constant pressure while the volume grows in proportion
/// to shear; q is a parabola with its top at shear_at_peak.
PathRecord sheared(double shear, double dilation_per_shear)
{
  PathRecord record;
  const double volume = dilation_per_shear * shear,
               share = shear / shear_at_peak, q = largest * share * (2 - share);
  for (unsigned i = 0; i < 3; ++i) {
    const bool axial = i == 2;
    record.F[i][i] = std::exp(volume / 3 + (axial ? -shear : shear / 2));
    record.response.stress[i][i] = -pressure + (axial ? -2. : 1.) / 3 * q;
  }
  return record;
}

/// Shears until the search has enough; the shear strain there.
double shear_until_ended(YieldSearch &search, double dilation_per_shear)
{
  for (double shear = 0; shear < 0.2; shear += 1e-3) {
    search.take(sheared(shear, dilation_per_shear));
    if (search.ended())
      return shear;
  }
  return 0.2;
}

ModuliOverPressure stiff()
{
  return ModuliOverPressure({MeasuredModuli{pressure, rigid, rigid}});
}

const YieldPoint *peak_of(const std::vector<YieldPoint> &points)
{
  for (const YieldPoint &point : points)
    if (point.criterion == YieldCriterion::peak)
      return &point;
  return nullptr;
}

TEST(YieldSearch, PeakIsFoundAlthoughThePowderDilatesOnItsWay)
{
  const ModuliOverPressure moduli = stiff();
  YieldSearch search({5e-4, 0}, moduli);
  // At the peak the volume has grown by 3 %.
  const double end = shear_until_ended(search, 0.375);
  EXPECT_GT(end, shear_at_peak);
  const auto points = search.points();
  const YieldPoint *peak = peak_of(points);
  ASSERT_NE(peak, nullptr);
  // Increments of 1e-3 are near the top of the parabola by 1e-4.
  EXPECT_NEAR(peak->deviatoric_stress / largest, 1, 1e-3);
}

TEST(YieldSearch, StateOfAnotherDensityIsNoPeak)
{
  const ModuliOverPressure moduli = stiff();
  // Compaction ends the search at 1 %, dilation at 5 %: before the peak. One
  // increment more or less.
  for (const auto &[dilation, shear] :
       {std::pair(-0.5, 0.02), std::pair(1., 0.05)}) {
    YieldSearch search({5e-4, 0}, moduli);
    EXPECT_NEAR(shear_until_ended(search, dilation), shear, 1.5e-3);
    EXPECT_EQ(peak_of(search.points()), nullptr);
  }
}
} // namespace
} // namespace tamp::fem
