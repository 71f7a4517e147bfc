// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/agcusnin.h>
#include <fem/laws/cap_remarks.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace tamp::fem
{
namespace
{
/// The one remark with these words; fails unless there is exactly one.
std::string the_remark(const DruckerPragerCapParameters &parameters,
                       const std::string &words)
{
  std::string found;
  unsigned count = 0;
  for (const Remark &remark : remarks(parameters))
    if (remark.text().find(words) != std::string::npos) {
      found = remark.text();
      ++count;
    }
  EXPECT_EQ(count, 1u) << words;
  return found;
}

DruckerPragerCapParameters complete()
{
  DruckerPragerCapParameters parameters;
  parameters.initial_relative_density = 0.3;
  parameters.elasticity = {1e9, 0.2};
  return parameters;
}

TEST(CapRemarks, NothingIsSaidOfCompleteTables)
{
  EXPECT_TRUE(remarks(complete()).empty());
}

TEST(CapRemarks, StartOffTheTableSaysItsYieldPressure)
{
  // ln(0.3411 / 0.3) = 0.1284; p_b lies on the line from 0.609 to 4.03 MPa over
  // ln(4 / 3): 2.136 MPa.
  DruckerPragerCapParameters parameters = complete();
  parameters.initial_relative_density = 0.3411;
  const auto text = the_remark(parameters, "0.3411");
  EXPECT_NE(text.find("0.1284"), std::string::npos) << text;
  EXPECT_NE(text.find("2.136 MPa"), std::string::npos) << text;
  EXPECT_NE(text.find("to 0.3 "), std::string::npos) << text;
}

TEST(CapRemarks, StartAtARowOfTheHardeningTableIsMeant)
{
  DruckerPragerCapParameters parameters = complete();
  parameters.hardening =
      DensityTable({{0, 0.1, 1.2}, {5e5, 6e5, 6e8}}, "hardening");
  parameters.initial_relative_density =
      parameters.reference_density * std::exp(0.1);
  for (const Remark &remark : remarks(parameters))
    EXPECT_EQ(remark.text().find("the powder starts"), std::string::npos)
        << remark.text();
}

TEST(CapRemarks, StartOutsideATableIsSaid)
{
  DruckerPragerCapParameters parameters = complete();
  parameters.elasticity.youngs_modulus =
      DensityTable({{0.5, 0.99}, {1e9, 2e9}}, "Young's modulus");
  const auto text = the_remark(parameters, "outside the table");
  EXPECT_NE(text.find("Young's modulus from 0.5 to 0.99"), std::string::npos)
      << text;
}

TEST(CapRemarks, StartBelowTheHardeningTableIsSaidOnce)
{
  DruckerPragerCapParameters parameters = complete();
  parameters.reference_density = 0.35;
  EXPECT_NE(the_remark(parameters, "starts at").find("without hardening"),
            std::string::npos);
}

TEST(CapRemarks, EarlyEndsOfTablesAreSaidTogether)
{
  const auto text = the_remark(DruckerPragerCapParameters(), "below 0.99");
  EXPECT_NE(text.find("Young's modulus and Poisson's ratio end at a relative "
                      "density of 0.98"),
            std::string::npos)
      << text;
}

TEST(CapRemarks, PowderThatWeakensIsSaid)
{
  DruckerPragerCapParameters parameters = complete();
  parameters.cohesion = DensityTable({{0.3, 0.99}, {2e4, 1e4}}, "cohesion");
  EXPECT_NE(the_remark(parameters, "cohesion falls").find("0.02 MPa"),
            std::string::npos);
  parameters = complete();
  parameters.friction_angle =
      DensityTable({{0.3, 0.99}, {1.2, 0.9}}, "friction angle");
  EXPECT_NE(the_remark(parameters, "angle falls").find("17.19"),
            std::string::npos);
  parameters = complete();
  parameters.eccentricity =
      DensityTable({{0.3, 0.8, 0.99}, {0.3, 0.3, 9}}, "cap eccentricity");
  EXPECT_NE(the_remark(parameters, "top of the cap").find("MPa"),
            std::string::npos);
  parameters = complete();
  parameters.cohesion = 5e6;
  EXPECT_NE(the_remark(parameters, "p_a").find("not above 0"),
            std::string::npos);
}

TEST(CapRemarks, PublishedPowdersStrengthen)
{
  for (const auto &parameters :
       {DruckerPragerCapParameters(), agcusnin::parameters()})
    for (const Remark &remark : remarks(parameters))
      EXPECT_EQ(remark.effect.find("weakens"), std::string::npos)
          << remark.text();
}
} // namespace
} // namespace tamp::fem
