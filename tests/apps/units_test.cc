// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/units.h>

#include <gtest/gtest.h>
#include <numbers>

using namespace tamp::apps;

namespace
{
// Products of a few factors of ten.
constexpr double rounding = 1e-14;

void expect_value(const std::string &text,
                  const Dimension &dimension,
                  double expected)
{
  EXPECT_NEAR(
      parse_quantity(text, dimension), expected, rounding * std::abs(expected))
      << text;
}
} // namespace

TEST(Units, AreTurnedIntoSI)
{
  expect_value("200 MPa", dimension::pressure, 200e6);
  expect_value("0.5GPa", dimension::pressure, 0.5e9);
  expect_value("600 um", dimension::length, 600e-6);
  expect_value("600 \u00b5m", dimension::length, 600e-6);
  expect_value("5 mm/min", dimension::speed, 5e-3 / 60);
  expect_value("30 deg", dimension::angle, std::numbers::pi / 6);
  expect_value("10 kN", dimension::force, 10e3);
  expect_value("4 g/cm3", dimension::density, 4000);
  expect_value("2650 kg/m^3", dimension::density, 2650);
  expect_value("1e-5 1/s", dimension::rate, 1e-5);
  expect_value("1e-5 s^-1", dimension::rate, 1e-5);
  expect_value("5 %", dimension::number, 0.05);
  expect_value("2 N/mm2", dimension::pressure, 2e6);
  expect_value("0.2 J/m2", dimension::surface_energy, 0.2);
}

TEST(Units, ABareNumberIsSI)
{
  expect_value(" 1e-3 ", dimension::length, 1e-3);
  expect_value("-0.5", dimension::pressure, -0.5);
}

TEST(Units, OfAnotherDimensionAreRefused)
{
  EXPECT_THROW(parse_quantity("200 mm", dimension::pressure), InputError);
  EXPECT_THROW(parse_quantity("30 deg", dimension::number), InputError);
  EXPECT_THROW(parse_quantity("5 %", dimension::length), InputError);
}

TEST(Units, NonsenseIsRefused)
{
  for (const char *text : {"", "MPa", "2 MPaa", "2 m/", "nan", "inf", "2,5 mm"})
    EXPECT_THROW(parse_quantity(text), InputError) << text;
}
