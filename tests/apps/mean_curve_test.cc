// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/probe_columns.h>
#include <apps/probe/mean_curve.h>

#include <cmath>
#include <gtest/gtest.h>

using namespace tamp::apps;

namespace
{
/// A stage of uniaxial strain up to 0.1, whose axial stress is proportional.
NumberTable curve(unsigned steps, double modulus)
{
  NumberTable table;
  table.names = probe_header();
  for (unsigned i = 0; i <= steps; ++i) {
    std::vector<double> row(table.names.size());
    row[table.column("stage")] = 1;
    const double strain = 0.1 * i / steps;
    row[table.column("strain_zz[-]")] = strain;
    row[table.column("stress_zz[Pa]")] = modulus * strain;
    table.rows.push_back(row);
  }
  return table;
}
} // namespace

TEST(MeanCurve, HasMeanAndDeviationOfEqualSteps)
{
  const NumberTable mean = mean_curve({curve(5, 1e6), curve(5, 3e6)});
  ASSERT_EQ(mean.rows.size(), 6u);
  const auto &last = mean.rows.back();
  EXPECT_DOUBLE_EQ(last[mean.column("stress_zz[Pa]")], 2e5);
  EXPECT_DOUBLE_EQ(last[mean.column("stress_zz_deviation[Pa]")],
                   std::sqrt(2.) * 1e5);
}

TEST(MeanCurve, ComparesOtherStepsAtTheSameStrain)
{
  const NumberTable mean = mean_curve({curve(4, 1e6), curve(7, 3e6)});
  ASSERT_EQ(mean.rows.size(), 8u);
  for (const auto &row : mean.rows)
    EXPECT_NEAR(row[mean.column("stress_zz[Pa]")],
                2e6 * row[mean.column("strain_zz[-]")],
                1e-9); // rounding
}
