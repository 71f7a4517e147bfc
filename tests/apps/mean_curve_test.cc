// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/probe_columns.h>
#include <apps/probe/mean_curve.h>

#include <cmath>
#include <gtest/gtest.h>

using namespace tamp::apps;

namespace
{
// Of numbers of the order of 1 after a few operations.
constexpr double rounding = 1e-12;
constexpr double unloading_modulus = 10; ///< over that of loading [-]

/// Appends a line of a path of axial strain.
void append(ProbeCurve &curve, double stage, double strain, double stress)
{
  NumberTable &table = curve.table;
  std::vector<double> row(table.names.size());
  row[0] = static_cast<double>(table.rows.size());
  row[table.column("stage")] = stage;
  row[table.column("strain_zz[-]")] = strain;
  row[table.column("stress_zz[Pa]")] = stress;
  table.rows.push_back(row);
}

ProbeCurve start()
{
  ProbeCurve curve;
  curve.table.names = probe_header();
  append(curve, 1, 0, 0);
  return curve;
}

/// Appends a stage from where the curve is to a strain: the stress changes by
/// the modulus times the strain. Steps grow by a ratio from each to the next.
void go_on(ProbeCurve &curve,
           double stage,
           double to,
           unsigned steps,
           double modulus,
           double ratio = 1)
{
  const auto &last = curve.table.rows.back();
  const double from = last[curve.table.column("strain_zz[-]")];
  const double stress = last[curve.table.column("stress_zz[Pa]")];
  double whole = 0, part = 0;
  for (unsigned i = 0; i < steps; ++i)
    whole += std::pow(ratio, i);
  for (unsigned i = 0; i < steps; ++i) {
    part += std::pow(ratio, i);
    const double way = (to - from) * part / whole;
    append(curve, stage, from + way, stress + modulus * way);
  }
}

/// Pressed to 0.1, unloaded to 0.09 and pressed again to 0.12; all stresses are
/// proportional to the modulus.
ProbeCurve three_stages(double modulus,
                        unsigned loading,
                        unsigned unloading,
                        unsigned again,
                        double ratio = 1)
{
  ProbeCurve curve = start();
  go_on(curve, 1, 0.1, loading, modulus, ratio);
  go_on(curve, 2, 0.09, unloading, unloading_modulus * modulus, ratio);
  go_on(curve, 3, 0.12, again, modulus, ratio);
  return curve;
}

double three_stage_stress(double stage, double strain)
{
  if (stage < 2)
    return strain;
  if (stage < 3)
    return 0.1 + unloading_modulus * (strain - 0.1);
  return 0.1 - unloading_modulus * 0.01 + strain - 0.09;
}

struct Line {
  double step, stage, strain, stress, deviation;
};

std::vector<Line> mean_of(const std::vector<ProbeCurve> &curves)
{
  const NumberTable mean = mean_curve(curves);
  std::vector<Line> lines;
  for (const auto &row : mean.rows)
    lines.push_back({row[0],
                     row[mean.column("stage")],
                     row[mean.column("strain_zz[-]")],
                     row[mean.column("stress_zz[Pa]")],
                     row[mean.column("stress_zz_deviation[Pa]")]});
  return lines;
}

/// Of curves of moduli 1 and 3: mean 2, deviation sqrt(2).
void expect_stresses_at_their_strains(const std::vector<Line> &lines)
{
  for (const Line &line : lines) {
    const double stress = three_stage_stress(line.stage, line.strain);
    EXPECT_NEAR(line.stress, 2 * stress, rounding) << "step " << line.step;
    EXPECT_NEAR(line.deviation, std::sqrt(2.) * std::abs(stress), rounding)
        << "step " << line.step;
  }
}
} // namespace

TEST(MeanCurve, HasMeanAndDeviationOfEqualSteps)
{
  const auto lines =
      mean_of({three_stages(1, 5, 3, 2), three_stages(3, 5, 3, 2)});
  ASSERT_EQ(lines.size(), 11u);
  expect_stresses_at_their_strains(lines);
}

TEST(MeanCurve, IsTheCurveOfASingleProbe)
{
  const ProbeCurve curve = three_stages(1, 5, 3, 2, 1.3);
  const NumberTable mean = mean_curve({curve});
  ASSERT_EQ(mean.rows.size(), curve.table.rows.size());
  for (std::size_t i = 0; i < mean.rows.size(); ++i)
    for (std::size_t k = 0; k < curve.table.names.size(); ++k)
      EXPECT_EQ(mean.rows[i][k], curve.table.rows[i][k]);
}

TEST(MeanCurve, ComparesOtherNumbersOfStepsAtTheSameStrain)
{
  const auto lines =
      mean_of({three_stages(1, 4, 6, 3), three_stages(3, 7, 2, 5, 1.4)});
  ASSERT_EQ(lines.size(), 1u + 7 + 6 + 5);
  expect_stresses_at_their_strains(lines);
}

TEST(MeanCurve, ComparesAsManyStepsOfOtherLengthAtTheSameStrain)
{
  const auto lines =
      mean_of({three_stages(1, 4, 4, 4), three_stages(3, 4, 4, 4, 1.5)});
  ASSERT_EQ(lines.size(), 13u);
  expect_stresses_at_their_strains(lines);
}

TEST(MeanCurve, NumbersStepsAndTurnsAtTheEndsOfStages)
{
  const auto lines =
      mean_of({three_stages(1, 4, 6, 3, 1.2), three_stages(3, 7, 2, 5)});
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].step, double(i));
    EXPECT_EQ(lines[i].stage, i <= 7 ? 1 : i <= 13 ? 2 : 3);
  }
  EXPECT_NEAR(lines[7].strain, 0.1, rounding);
  EXPECT_NEAR(lines[13].strain, 0.09, rounding);
  EXPECT_NEAR(lines.back().strain, 0.12, rounding);
}

TEST(MeanCurve, ComparesStagesOfOtherLengthAtTheSameShares)
{
  ProbeCurve shorter = start(), longer = start();
  go_on(shorter, 1, 0.1, 3, 1);
  go_on(longer, 1, 0.2, 5, 1);
  const auto lines = mean_of({shorter, longer});
  ASSERT_EQ(lines.size(), 6u);
  for (std::size_t i = 0; i < lines.size(); ++i)
    EXPECT_NEAR(lines[i].strain, 0.15 * double(i) / 5, rounding);
}

TEST(MeanCurve, EndsWhereTheFirstCurveBrokeOff)
{
  // Broken off 0.004 before the end of unloading, at 0.094.
  ProbeCurve broken = start();
  go_on(broken, 1, 0.1, 5, 1);
  go_on(broken, 2, 0.094, 4, unloading_modulus);
  broken.ended = false;
  const auto lines = mean_of({three_stages(3, 7, 6, 2, 1.2), broken});
  expect_stresses_at_their_strains(lines);
  EXPECT_EQ(lines.back().stage, 2);
  EXPECT_NEAR(lines.back().strain, 0.094, rounding);
}

TEST(MeanCurve, EndsWithTheEarliestStageOfCurvesThatBrokeOff)
{
  ProbeCurve early = start(), late = three_stages(3, 5, 5, 1);
  go_on(early, 1, 0.05, 5, 1);
  early.ended = late.ended = false;
  const auto lines = mean_of({late, early});
  expect_stresses_at_their_strains(lines);
  EXPECT_NEAR(lines.back().strain, 0.05, rounding);
  EXPECT_EQ(lines.back().stage, 1);
}

TEST(MeanCurve, IsTheStartIfACurveHasNothingElse)
{
  ProbeCurve broken = start();
  broken.ended = false;
  EXPECT_EQ(mean_of({three_stages(1, 3, 3, 3), broken}).size(), 1u);
}

// Such as an unloading to a stress that the powder has not reached.
TEST(MeanCurve, WaitsForCurvesThatSkipAStage)
{
  ProbeCurve skipping = start();
  go_on(skipping, 1, 0.1, 5, 3);
  go_on(skipping, 3, 0.12, 4, 3);
  const auto lines = mean_of({three_stages(1, 5, 4, 2), skipping});
  ASSERT_EQ(lines.size(), 1u + 5 + 4 + 4);
  // Unloaded by the mean of 0.01 and nothing, then pressed by that of 0.03 and
  // 0.02.
  EXPECT_NEAR(lines[9].strain, 0.095, rounding);
  EXPECT_NEAR(lines[9].stress, (0.1 - 0.1 + 0.3) / 2, rounding);
  EXPECT_NEAR(lines.back().strain, 0.12, rounding);
  EXPECT_EQ(lines.back().stage, 3);
}

TEST(MeanCurve, KeepsAStageThatOnlyOneCurveTakesAtTheEnd)
{
  ProbeCurve skipping = start();
  go_on(skipping, 1, 0.1, 5, 1);
  const auto lines = mean_of({skipping, three_stages(1, 5, 4, 2)});
  ASSERT_EQ(lines.size(), 12u);
  EXPECT_NEAR(lines.back().strain, 0.11, rounding);
}

TEST(MeanCurve, ComparesStressesAtRestLineByLine)
{
  ProbeCurve slow = start(), fast = start();
  for (const double stress : {1., 2., 3., 4.})
    append(slow, 1, 0, stress);
  for (const double stress : {5., 8.})
    append(fast, 1, 0, stress);
  const auto lines = mean_of({slow, fast});
  ASSERT_EQ(lines.size(), 5u);
  // Halfway of both, and their ends.
  EXPECT_NEAR(lines[2].stress, (2. + 5) / 2, rounding);
  EXPECT_NEAR(lines[4].stress, (4. + 8) / 2, rounding);
}
