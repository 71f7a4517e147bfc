// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/curve_targets.h>
#include <apps/calibrate/fit_confidence.h>
#include <apps/calibrate/surrogate_search.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <stdexcept>
#include <vector>

using namespace tamp::apps;
using Eigen::VectorXd;

namespace
{
// A curve of some stiffness whose lateral share, recovered strain and start are
// given.
CompactionCurve curve_of(double factor, double share, double recovery)
{
  CompactionCurve curve;
  curve.has_lateral = true;
  for (int i = 0; i <= 40; ++i) {
    const double density = 0.5 + 0.3 * i / 40;
    const double axial = factor * 1e4 * std::exp(20 * (density - 0.5));
    curve.loading.push_back({density, axial, share * axial});
  }
  const double peak = curve.peak().axial;
  for (int i = 1; i <= 18; ++i) {
    const double left = 1 - 0.05 * i;
    curve.unloading.push_back(
        {curve.peak().relative_density * std::exp(-recovery * (1 - left)),
         left * peak,
         share * left * peak});
  }
  return curve;
}

// Residuals of y = a exp(-b t) sampled in time, with noise by number.
struct Decay {
  std::vector<double> data;
  double low = 0.1, high = 10;
  int runs = 0;

  explicit Decay(unsigned seed, double noise)
  {
    std::mt19937 draw(seed);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 30; ++i)
      data.push_back(value(2, 0.7, i) * (1 + noise * normal(draw)));
  }
  static double value(double a, double b, int i)
  {
    return a * std::exp(-b * 0.1 * i);
  }
  double at(double place) const { return low * std::pow(high / low, place); }

  std::vector<VectorXd> operator()(const std::vector<VectorXd> &places)
  {
    std::vector<VectorXd> all;
    for (const VectorXd &place : places) {
      ++runs;
      VectorXd residuals(30);
      for (int i = 0; i < 30; ++i)
        residuals[i] = value(at(place[0]), at(place[1]), i) / data[i] - 1;
      all.push_back(residuals);
    }
    return all;
  }

  SearchEnd search()
  {
    SearchLimits limits;
    limits.dimension = 2;
    return search_least_squares(limits,
                                [this](const std::vector<VectorXd> &places,
                                       bool) { return (*this)(places); });
  }

  std::vector<FitParameter> parameters() const
  {
    return {{"Some/A", "-", low, high, true}, {"Some/B", "-", low, high, true}};
  }
};
} // namespace

TEST(CurveTargets, AreMetByTheCurveThatTheyCameFrom)
{
  const auto curve = curve_of(1, 0.4, 0.02);
  const CurveTargets targets(curve, 0.55);
  const auto residuals = targets.residuals(curve);
  ASSERT_TRUE(residuals);
  // The places are nodes of the curve: rounding only.
  EXPECT_LT(misfit_of(*residuals), 1e-12);
  EXPECT_NEAR(targets.largest_density(), 0.8, 1e-12);
  EXPECT_NEAR(targets.lowest_share(), 0.1, 1e-12);
  // 34 densities above 0.55, 18 places of unloading, each with lateral
  // pressure.
  EXPECT_EQ(targets.all().size(), 2u * (34 + 18));
  EXPECT_EQ(targets.all().size(), 2u * (34 + 18));
}

TEST(CurveTargets, AllDecadesOfPressureCountAlike)
{
  // From here on lateral pressures, too, are above a hundredth of the peak.
  const CurveTargets targets(curve_of(1, 0.4, 0.02), 0.62);
  const auto residuals = targets.residuals(curve_of(1.1, 0.4, 0.02));
  ASSERT_TRUE(residuals);
  for (std::size_t i = 0; i < residuals->size(); ++i) {
    const TargetKind kind = targets.all()[i].kind;
    const bool loading = kind == TargetKind::loading_axial ||
                         kind == TargetKind::loading_lateral;
    // What loading misses is not counted again in unloading.
    EXPECT_NEAR((*residuals)[i], loading ? 0.1 : 0.0, 1e-9) << i;
  }
}

TEST(CurveTargets, UnloadingFeelsRecoveredStrain)
{
  const CurveTargets targets(curve_of(1, 0.4, 0.02), 0.55);
  const auto residuals = targets.residuals(curve_of(1, 0.4, 0.03));
  ASSERT_TRUE(residuals);
  double largest = 0;
  for (std::size_t i = 0; i < residuals->size(); ++i)
    if (targets.all()[i].kind == TargetKind::unloading_strain)
      largest = std::max(largest, (*residuals)[i]);
    else
      EXPECT_NEAR((*residuals)[i], 0, 1e-9) << i;
  EXPECT_NEAR(largest, 0.5, 1e-9); // half as much again, at the end
}

TEST(CurveTargets, AreNotMetByACurveThatEndsBefore)
{
  const CurveTargets targets(curve_of(1, 0.4, 0.02), 0.55);
  CompactionCurve shorter = curve_of(1, 0.4, 0.02);
  shorter.unloading.resize(5);
  EXPECT_FALSE(targets.residuals(shorter));
  EXPECT_EQ(targets.reach(shorter),
            "it comes to a relative density of 0.8 and back to 75 % of its "
            "peak pressure, the measured curve to 0.8 and 10 %");
  shorter.loading.resize(20);
  EXPECT_FALSE(targets.residuals(shorter));
  EXPECT_THROW(CurveTargets(curve_of(1, 0.4, 0.02), 0.79),
               std::invalid_argument);
}

TEST(CurveTargets, AreMetAsFarAsEquilibriumTellsTheEndOfUnloading)
{
  const CurveTargets targets(curve_of(1, 0.4, 0.02), 0.55);
  CompactionCurve curve = curve_of(1, 0.4, 0.02);
  const double end = curve.unloading.back().axial;
  curve.unloading.back().axial = 1.01 * end; // by 1e-3 of the peak
  EXPECT_TRUE(targets.residuals(curve));
  curve.unloading.back().axial = 1.05 * end;
  EXPECT_FALSE(targets.residuals(curve));
}

TEST(SurrogateSearch, FindsTheLeastSumOfSquaresInFewRuns)
{
  Decay decay(1, 0);
  const SearchEnd end = decay.search();
  const SearchSample &best = end.samples[end.best];
  EXPECT_TRUE(end.converged);
  // Bounds two decades wide; the search stops at a hundredth of them, 5 %.
  EXPECT_NEAR(decay.at(best.place[0]) / 2, 1, 0.01);
  EXPECT_NEAR(decay.at(best.place[1]) / 0.7, 1, 0.01);
  // Which BOBYQA takes some 80 runs for, one after the other.
  EXPECT_LE(decay.runs, 40);
}

TEST(SurrogateSearch, StaysWithinBoundsAndPassesFailedRunsOver)
{
  SearchLimits limits;
  limits.dimension = 2;
  const SearchEnd end = search_least_squares(
      limits, [](const std::vector<VectorXd> &places, bool) {
        std::vector<VectorXd> all;
        for (const VectorXd &place : places) {
          EXPECT_GE(place.minCoeff(), 0);
          EXPECT_LE(place.maxCoeff(), 1);
          VectorXd residuals(3);
          residuals << place[0] + 0.5, place[1] - 0.3, place[0] * place[1];
          all.push_back(place[0] > 0.8 ? VectorXd() : residuals);
        }
        return all;
      });
  const VectorXd &best = end.samples[end.best].place;
  EXPECT_NEAR(best[0], 0, 1e-9); // beyond the bound it would be better
  EXPECT_NEAR(best[1], 0.3, 1e-2);
  EXPECT_THROW(static_cast<void>(search_least_squares(
                   limits,
                   [](const std::vector<VectorXd> &places, bool) {
                     return std::vector<VectorXd>(places.size());
                   })),
               std::runtime_error);
}

TEST(FitConfidence, IntervalsHoldTheTruthAsOftenAsTheySay)
{
  constexpr int seeds = 40;
  int held = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    Decay decay(seed, 0.05);
    const SearchEnd end = decay.search();
    const FitConfidence confidence =
        confidence_of(decay.parameters(), end.samples[end.best], end.jacobian);
    const auto &[a, b] =
        std::pair(confidence.estimates[0], confidence.estimates[1]);
    held += a.low <= 2 && 2 <= a.high && b.low <= 0.7 && 0.7 <= b.high;
    EXPECT_NEAR(confidence.noise, 0.05, 0.025); // four of its own errors
  }
  // Of 40, both hold in 0.95^2 or more; three binomial deviations below that.
  EXPECT_GE(held, 29);
}

TEST(FitConfidence, SaysWhatTheDataCannotTell)
{
  // Residuals feel the sum of the first two parameters only, and nothing of the
  // third.
  constexpr int count = 20;
  Eigen::MatrixXd jacobian(count, 3);
  SearchSample best{VectorXd::Constant(3, 0.5), VectorXd(count)};
  for (int i = 0; i < count; ++i) {
    jacobian.row(i) << 1.0, 1.0, 0.0;
    best.residuals[i] = i % 2 ? 0.01 : -0.01;
  }
  const std::vector<FitParameter> parameters{{"S/A", "-", 1, 2, false},
                                             {"S/B", "-", 1, 2, false},
                                             {"S/C", "-", 1, 2, false}};
  const FitConfidence confidence = confidence_of(parameters, best, jacobian);
  EXPECT_LT(confidence.correlation(0, 1), -0.99);
  EXPECT_NEAR(confidence.correlation(0, 2), 0, 1e-9);
  EXPECT_TRUE(confidence.estimates[2].flat);
  EXPECT_FALSE(confidence.estimates[0].determined);
  EXPECT_EQ(confidence.estimates[2].low, 1);
  EXPECT_EQ(confidence.estimates[2].high, 2);
  const auto words = confidence_words(parameters, confidence);
  ASSERT_EQ(words.size(), 4u);
  EXPECT_NE(words[2].text.find("the data cannot tell"), std::string::npos);
  EXPECT_NE(
      words[3].text.find("S/A and S/B trade off: correlation -1.00; the data "
                         "cannot tell them apart"),
      std::string::npos);
}

TEST(FitConfidence, SaysThatAnEstimateIsAtItsBound)
{
  SearchSample best{VectorXd::Constant(1, 1.0), VectorXd::Constant(9, 0.01)};
  const std::vector<FitParameter> parameters{{"S/A", "Pa", 1e6, 2e6, false}};
  const FitConfidence confidence =
      confidence_of(parameters, best, Eigen::MatrixXd::Ones(9, 1));
  EXPECT_TRUE(confidence.estimates[0].at_bound);
  EXPECT_NE(
      confidence_words(parameters, confidence)[0].text.find("at its bound"),
      std::string::npos);
}
