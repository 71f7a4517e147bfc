// SPDX-License-Identifier: BSD-3-Clause
#include <apps/fit/cap_fit.h>
#include <apps/input/units.h>

#include <cmath>

#include "fit_place.h"

namespace tamp::apps
{
namespace
{
const std::string curve_header =
    "strain_xx[-],strain_yy[-],strain_zz[-],stress_zz[Pa],pressure[Pa],"
    "deviatoric_stress[Pa],relative_density[-]\n";
const std::string yield_header =
    "replica[-],relative_density[-],reached_pressure[Pa],"
    "reached_deviatoric_stress[Pa],branch[-],criterion[-],pressure[Pa],"
    "deviatoric_stress[Pa],plastic_volumetric_strain[-],plastic_shear_strain[-]"
    "\n";
const std::string moduli_header = "replica[-],relative_density[-],pressure[Pa],"
                                  "bulk_modulus[Pa],shear_modulus[Pa]\n";

// Uniaxial strain from D = 0.5 with stresses that grow as D^6.
std::string curve(double lateral = 0)
{
  std::string text = "# remark\n" + curve_header;
  for (int i = 0; i <= 60; ++i) {
    const double strain = 0.01 * i, D = 0.5 * std::exp(strain),
                 p = 1e6 * std::pow(D / 0.5, 6);
    text += std::to_string(lateral * strain) + ",0," + std::to_string(strain) +
            "," + std::to_string(1.4 * p) + "," + std::to_string(p) + "," +
            std::to_string(0.6 * p) + "," + std::to_string(D) + "\n";
  }
  return text;
}

std::string yields(const std::vector<double> &densities)
{
  std::string text = yield_header;
  for (const double D : densities) {
    const double p = 1e6 * std::pow(D / 0.5, 6);
    for (const double share : {0.05, 0.1})
      text += "0," + std::to_string(D) + "," + std::to_string(p) + "," +
              std::to_string(0.6 * p) + ",0,0," + std::to_string(share * p) +
              "," + std::to_string(1.2 * share * p) + ",0,5e-4\n";
  }
  return text;
}

const std::string moduli = moduli_header + "0,0.6,1e6,1e9,6e8\n"
                                           "0,0.8,1e7,4e9,2e9\n";

void write_good(const FitPlace &place)
{
  place.write("a/curve.csv", curve());
  place.write("a/yield.csv", yields({0.6, 0.65, 0.7, 0.75}));
  place.write("a/moduli.csv", moduli);
}

// What is said of the folder `a`; empty if it can be fitted.
std::string complaint(const FitPlace &place)
{
  try {
    fit_cap({read_probe(place / "a")}, YieldCriterion::strain);
    return "";
  } catch (const InputError &error) {
    return error.what();
  }
}

void expect_said(const FitPlace &place, const std::string &words)
{
  const std::string said = complaint(place);
  EXPECT_NE(said.find(words), std::string::npos)
      << "'" << said << "' lacks '" << words << "'";
}

TEST(ProbeData, GoodFolderIsFitted)
{
  const FitPlace place;
  write_good(place);
  EXPECT_EQ(complaint(place), "");
}

TEST(ProbeData, WindowsLineEndsAreRead)
{
  const FitPlace place;
  write_good(place);
  std::string text = curve();
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;
       at += 2)
    text.insert(at, 1, '\r');
  place.write("a/curve.csv", text);
  EXPECT_EQ(complaint(place), "");
}

TEST(ProbeData, MissingFolderAndFilesAreNamed)
{
  const FitPlace place;
  expect_said(place, "there is no folder");
  write_good(place);
  std::filesystem::remove(place / "a/yield.csv");
  expect_said(place, "there is no yield.csv");
  write_good(place);
  std::filesystem::remove(place / "a/moduli.csv");
  expect_said(place, "no elastic moduli");
  write_good(place);
  std::filesystem::remove(place / "a/curve.csv");
  expect_said(place, "there is no curve of a probe");
}

TEST(ProbeData, EmptyTablesAreRefused)
{
  const FitPlace place;
  for (const std::string text : {"", "# remark only\n"}) {
    write_good(place);
    place.write("a/curve.csv", text);
    expect_said(place, "there is no column");
  }
  write_good(place);
  place.write("a/curve.csv", curve_header + "0,0,0,1,1,0,0.5\n");
  expect_said(place, "the curve has 1 states");
  write_good(place);
  place.write("a/yield.csv", yield_header);
  expect_said(place, "the table has no yield points");
  write_good(place);
  place.write("a/moduli.csv", moduli_header);
  expect_said(place, "the table has no moduli");
}

TEST(ProbeData, TwoDensitiesAreTooFew)
{
  const FitPlace place;
  write_good(place);
  place.write("a/yield.csv", yields({0.6, 0.7}));
  expect_said(place, "at least 3 relative densities");
  expect_said(place, "there are 2");
}

TEST(ProbeData, MissingColumnAndWrongUnitAreNamed)
{
  const FitPlace place;
  write_good(place);
  std::string text = yields({0.6, 0.7, 0.8});
  text.replace(text.find("criterion"), 9, "criterium");
  place.write("a/yield.csv", text);
  expect_said(place, "yield.csv:1: there is no column 'criterion[-]'");
  write_good(place);
  text = curve();
  text.replace(text.find("stress_zz[Pa]"), 13, "stress_zz[mm]");
  place.write("a/curve.csv", text);
  expect_said(place, "curve.csv:2");
}

TEST(ProbeData, WhatIsNoNumberIsNamedWithItsLine)
{
  const FitPlace place;
  for (const std::string word : {"nan", "inf", "x", ""}) {
    write_good(place);
    place.write("a/moduli.csv", moduli + "0,0.9,1e7," + word + ",2e9\n");
    expect_said(place,
                "moduli.csv:4: '" + word + "': expected a finite number");
  }
  write_good(place);
  place.write("a/moduli.csv", moduli + "0,0.9,1e7,2e9\n");
  expect_said(place, "moduli.csv:4");
  write_good(place);
  place.write("a/moduli.csv", moduli + "0,0.9,1e7,2e9,-1\n");
  expect_said(place, "expected moduli above zero");
}

TEST(ProbeData, LoadingThatIsNeitherIsRefused)
{
  const FitPlace place;
  write_good(place);
  place.write("a/curve.csv", curve(0.5));
  expect_said(place, "expected uniaxial loading");
}

TEST(ProbeData, StatesAboveTheShearLineAreExplained)
{
  const FitPlace place;
  write_good(place);
  std::string weak = yield_header;
  for (const double D : {0.6, 0.65, 0.7}) {
    const double p = 1e6 * std::pow(D / 0.5, 6);
    weak += "0," + std::to_string(D) + "," + std::to_string(p) + "," +
            std::to_string(0.6 * p) + ",0,0," + std::to_string(0.1 * p) + "," +
            std::to_string(0.05 * p) + ",0,5e-4\n";
  }
  place.write("a/yield.csv", weak);
  expect_said(place, "not below the shear line");
}
} // namespace
} // namespace tamp::apps
