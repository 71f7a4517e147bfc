// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/compaction_equations.h>
#include <apps/fit/equation_report.h>
#include <apps/input/units.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

using namespace tamp::apps;

namespace
{
using Law = std::function<double(double)>;
constexpr double initial = 0.36; // relative density before compaction [-]
constexpr double exact = 1e-10;  // relative, of logarithms of 1e8 Pa in doubles

/// Forty pressures from 0.2 MPa to 200 MPa, in equal ratios.
std::vector<double> pressures()
{
  std::vector<double> pressure;
  for (int i = 0; i < 40; ++i)
    pressure.push_back(0.2e6 * std::pow(1e3, i / 39.));
  return pressure;
}

/// The fit of a name to a curve of a law, with densities that are off by up to
/// `noise`, up and down without order.
CompactionFit fit_of(const std::string &name, const Law &law, double noise = 0)
{
  const auto pressure = pressures();
  std::vector<double> density;
  for (std::size_t i = 0; i < pressure.size(); ++i)
    density.push_back(law(pressure[i]) +
                      noise * std::sin(7919. * static_cast<double>(i + 1)));
  for (const auto &fit : fit_compaction_equations(pressure, density, initial))
    if (fit.name == name)
      return fit;
  ADD_FAILURE() << "no fit " << name;
  return {};
}

struct KnownLaw {
  std::string name;
  Law law;
  double first, second; ///< parameters
  double scatter;       ///< of the parameters with the noise, relative
};

// With noise of 5e-4 the parameters of logarithms of small porosities and
// strains scatter by a few per cent.
const std::vector<KnownLaw> laws{
    {"heckel",
     [](double P) { return 1 - std::exp(-(P / 150e6 + 0.5)); },
     150e6,
     0.5,
     0.01},
    {"kawakita",
     [](double P) {
       const double C = 0.5 * P / (3e6 + P);
       return initial / (1 - C);
     },
     0.5,
     3e6,
     0.01},
    {"walker",
     [](double P) { return 1 / (2 - 0.15 * std::log(P / 1e6)); },
     0.15,
     2,
     0.01},
    {"panelli-ambrosio",
     [](double P) { return 1 - std::exp(-(1e-4 * std::sqrt(P) + 0.45)); },
     1e-4,
     0.45,
     0.01},
    {"adams",
     [](double P) { return initial * std::pow(1 + 6 * P / 20e6, 1. / 6); },
     20e6,
     6,
     0.03}};
} // namespace

TEST(CompactionEquations, FindTheParametersOfExactData)
{
  for (const KnownLaw &known : laws) {
    const auto fit = fit_of(known.name, known.law);
    EXPECT_NEAR(fit.parameters.at(0).second / known.first, 1, exact)
        << known.name;
    EXPECT_NEAR(fit.parameters.at(1).second / known.second, 1, exact)
        << known.name;
    EXPECT_NEAR(fit.r_squared, 1, exact) << known.name;
    EXPECT_LT(fit.density_error, exact) << known.name;
    EXPECT_EQ(fit.highest_pressure, pressures().back()) << known.name;
    for (std::size_t i = 0; i < pressures().size(); ++i)
      EXPECT_NEAR(fit.fitted_density[i], known.law(pressures()[i]), exact)
          << known.name;
  }
}

TEST(CompactionEquations, FindTheParametersOfNoisyData)
{
  constexpr double noise = 5e-4;
  for (const KnownLaw &known : laws) {
    const auto fit = fit_of(known.name, known.law, noise);
    EXPECT_NEAR(fit.parameters.at(0).second / known.first, 1, known.scatter)
        << known.name;
    EXPECT_NEAR(fit.parameters.at(1).second / known.second, 1, known.scatter)
        << known.name;
    // Never better than data that are off by noise at most can be.
    EXPECT_LT(fit.r_squared, 1) << known.name;
    EXPECT_LT(fit.density_error, 2 * noise) << known.name;
    EXPECT_GT(fit.density_error, noise / 4) << known.name;
  }
}

TEST(CompactionEquations, HeckelTakesTheLinearPartAlone)
{
  // Rearrangement bends the curve below 40 MPa.
  const auto fit = fit_of("heckel", [](double P) {
    const double bend = 0.3 * std::exp(-P / 4e6);
    return 1 - std::exp(-(P / 150e6 + 0.8 - bend));
  });
  EXPECT_GT(fit.lowest_pressure, 4e6);
  EXPECT_LT(fit.lowest_pressure, 40e6);
  EXPECT_EQ(fit.highest_pressure, pressures().back());
  EXPECT_GE(fit.r_squared, 0.999);
  // The bend that r^2 >= 0.999 lets in.
  EXPECT_NEAR(fit.parameters[0].second / 150e6, 1, 0.05);
}

TEST(CompactionEquations, CurvesThatCannotBeFittedAreRefused)
{
  const auto refusal = [](const std::vector<double> &P,
                          const std::vector<double> &D,
                          double start = initial) -> std::string {
    try {
      fit_compaction_equations(P, D, start);
    } catch (const std::invalid_argument &error) {
      return error.what();
    }
    return "none";
  };
  const std::vector<double> P{1e6, 2e6, 3e6}, D{0.4, 0.5, 0.6};
  EXPECT_EQ(refusal(P, D), "none");
  const auto names = [](const std::string &text, const std::string &part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  names(refusal({0, 2e6, 3e6}, D), "0: expected pressures above 0 Pa");
  names(refusal({-1e6, 2e6, 3e6}, D), "-1e+06: expected pressures above 0");
  names(refusal({1e6, 3e6, 2e6}, D), "2e+06: expected pressures");
  names(refusal({1e6, 2e6, NAN}, D), "nan: expected pressures");
  names(refusal(P, {0.4, 0.5, 1}), "1: expected relative densities");
  names(refusal(P, {0.4, 0.5, NAN}), "nan: expected relative densities");
  names(refusal(P, D, 0), "0: expected an initial relative density");
  names(refusal({1e6, 2e6}, {0.4, 0.5}), "2: expected at least three points");
  names(refusal({}, {}), "0: expected at least three points");
  names(refusal(P, D, 0.45), "2: expected at least three points above");
  names(refusal({1e6}, D), "3: expected as many densities");
}

TEST(CompactionEquations, ACurveFlatterThanAnyOfAdamsIsSaidToBe)
{
  // Strain rises faster than pressure.
  const auto fit = fit_of("adams", [](double P) {
    return initial * std::exp(0.4 * std::pow(P / 200e6, 1.5));
  });
  EXPECT_TRUE(std::isnan(fit.parameters[0].second));
  EXPECT_NE(fit.remark.find("less steeply"), std::string::npos) << fit.remark;
}

TEST(EquationReport, TakesTheLoadingPartOfAProbeAndOfADie)
{
  namespace fs = std::filesystem;
  const fs::path home = fs::temp_directory_path() /
                        ("tamp_equations_" + std::to_string(getpid()));
  fs::create_directories(home / "probe");
  fs::create_directories(home / "die");
  std::ofstream probe(home / "probe" / "curve.csv");
  std::ofstream die(home / "die" / "curve.csv");
  probe << "# a remark\nstep,stress_zz[Pa],relative_density[-]\n";
  die << "upper_pressure[Pa],lower_pressure[Pa],mean_relative_density[-]\n";
  const auto write = [&](double P, double D) {
    probe << "1," << P << ',' << D << '\n';
    die << 1.2 * P << ',' << 0.8 * P << ',' << D << '\n';
  };
  write(0, initial);
  for (const double P : {1e6, 2e6, 4e6, 8e6})
    write(P, laws[2].law(P));
  write(4e6, 0.61); // unloading, which is left out
  write(1e6, 0.6);
  probe.close();
  die.close();
  for (const char *folder : {"probe", "die"}) {
    const auto report = report_equations(home / folder, "walker");
    ASSERT_EQ(report.results.size(), 6u);
    EXPECT_EQ(report.results[0].first, "walker_coefficient[-]");
    // Numbers of six digits in the file.
    EXPECT_NEAR(report.results[0].second, 0.15, 1e-5);
    EXPECT_EQ(report.results[5].first, "walker_highest_pressure[Pa]");
    EXPECT_EQ(report.results[5].second, 8e6);
    EXPECT_EQ(report.plots.size(), 1u);
    ASSERT_EQ(report.remarks.size(), 1u);
    EXPECT_EQ(report.remarks[0].find("walker: 1/D = "), 0u);
    EXPECT_EQ(report.header,
              (std::vector<std::string>{
                  "pressure[Pa]", "relative_density[-]", "walker[-]"}));
    EXPECT_EQ(report.lines.size(), 4u);
  }
  EXPECT_EQ(report_equations(home / "die", "all-equations").results.size(),
            30u);
  // A powder without pressure at the start; then one that has been pressed.
  const auto report = [&] {
    return report_equations(home / "die", "kawakita");
  };
  EXPECT_EQ(report().warnings.size(), 0u);
  std::ofstream(home / "die" / "curve.csv")
      << "upper_pressure[MPa],lower_pressure[MPa],mean_relative_density[%]\n"
         "1,1,50\n2,2,51\n3,3,53\n4,4,56\n";
  ASSERT_EQ(report().warnings.size(), 2u);
  EXPECT_NE(report().warnings[0].find("a is not between"), std::string::npos);
  EXPECT_NE(report().warnings[1].find("begins at 1 MPa"), std::string::npos);
  EXPECT_THROW(report_equations(home / "none", "adams"), InputError);
  fs::remove_all(home);
}
