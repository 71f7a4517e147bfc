// SPDX-License-Identifier: BSD-3-Clause
#include <dem/remarks.h>
#include <tests/dem/sample_cells.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <utility>

namespace tamp::dem
{
namespace
{
using Kind = Remark::Kind;

bool says(const std::vector<Remark> &remarks, Kind kind)
{
  return std::ranges::any_of(remarks, [kind](const Remark &remark) {
    return remark.kind == kind && !remark.text.empty();
  });
}

constexpr double one_megapascal = 1e6;

TEST(Remarks, AGoodCellNeedsNone)
{
  EXPECT_TRUE(judge(test::alumina_cell(), {}, one_megapascal).empty());
}

TEST(Remarks, EachDoubtIsNamedAlone)
{
  const auto only = [](const UnitCell &cell, Kind kind) {
    const auto remarks = judge(cell, {}, one_megapascal);
    return remarks.size() == 1 && says(remarks, kind);
  };
  UnitCell dense = test::alumina_cell();
  dense.box.h *= std::cbrt(dense.relative_density() / 0.83);
  EXPECT_TRUE(only(dense, Kind::beyond_pair_laws));

  UnitCell narrow = test::alumina_cell();
  narrow.box.h.col(0) *= 0.4;
  narrow.box.h.col(1) /= 0.4;
  EXPECT_TRUE(only(narrow, Kind::box_narrow));

  UnitCell misprint = test::alumina_cell(); // Sheng et al. (2004), table I
  misprint.materials[0].youngs_modulus = 70e6;
  misprint.materials[0].limiting_pressure = 0.5e9;
  EXPECT_TRUE(only(misprint, Kind::yields_out_of_range));
  misprint.contact.normal_law = NormalLaw::hertz;
  EXPECT_TRUE(judge(misprint, {}, one_megapascal).empty());
}

TEST(Remarks, AdhesionMayMakeContactsThatAreNotSmall)
{
  // a / R* = (9 pi Gamma / (2 E* R*))^(1/3) with E* = 1.92 GPa and R* = 112 um
  // passes sqrt(0.1) at 480 J/m2.
  UnitCell cell = test::alumina_cell();
  cell.contact.normal_law = NormalLaw::jkr;
  cell.contact.work_of_adhesion = 460;
  EXPECT_TRUE(judge(cell, {}, one_megapascal).empty());
  cell.contact.work_of_adhesion = 500;
  EXPECT_TRUE(says(judge(cell, {}, one_megapascal), Kind::adhesion_flattens));
}

TEST(Remarks, StorakersGrainsMustYieldInSmallContacts)
{
  // 8 c^2 (p_y / E*)^2 passes 0.1 at p_y = 0.0935 E*, here 180 MPa.
  UnitCell cell = test::alumina_cell();
  cell.contact.normal_law = NormalLaw::storakers;
  cell.materials[0].limiting_pressure = 175e6;
  EXPECT_TRUE(judge(cell, {}, one_megapascal).empty());
  cell.materials[0].limiting_pressure = 185e6;
  EXPECT_TRUE(says(judge(cell, {}, one_megapascal), Kind::yields_out_of_range));
}

TEST(Remarks, OfAMixtureTellWhichContactsAreMeantInAnyOrder)
{
  UnitCell cell = test::alumina_cell();
  cell.materials.push_back(cell.materials[0]);
  cell.materials[1].youngs_modulus = 70e6; // against p_y = 50 MPa
  cell.species.assign(cell.size(), 0);
  // A material that no grain has tells nothing.
  EXPECT_TRUE(judge(cell, {}, one_megapascal).empty());
  for (std::uint8_t soft : {1, 0}) {
    for (std::size_t i = 0; i < cell.size(); ++i)
      cell.species[i] = i % 3 == 0 ? soft : 1 - soft;
    const auto remarks = judge(cell, {}, one_megapascal);
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_EQ(remarks[0].kind, Kind::yields_out_of_range);
    const std::string number = std::to_string(soft + 1);
    EXPECT_NE(remarks[0].text.find("species " + number + " and " + number),
              std::string::npos)
        << remarks[0].text;
    std::swap(cell.materials[0], cell.materials[1]);
  }
}

TEST(Remarks, TellTheValueTheBoundAndWhichIsWorse)
{
  UnitCell cell = test::alumina_cell();
  const auto at_density = [&](double density) {
    cell.box.h *= std::cbrt(cell.relative_density() / density);
    return judge(cell, {}, one_megapascal).at(0);
  };
  const Remark dense = at_density(0.83), denser = at_density(0.84);
  for (const char *number : {"0.83;", "0.82 "})
    EXPECT_NE(dense.text.find(number), std::string::npos) << dense.text;
  EXPECT_TRUE(worse(denser, dense));
  EXPECT_FALSE(worse(dense, denser));
  // A bound from below.
  const Remark narrow{Kind::box_narrow, 2.9, 3}, narrower{narrow.kind, 2.5, 3};
  EXPECT_TRUE(worse(narrower, narrow));
}

TEST(Remarks, FastDrivingIsNotQuasiStaticWhereStressIsLow)
{
  Driving driving;
  driving.method = Method::dynamics;
  driving.dynamics.strain_rate = 2e-5;
  // I = rate d sqrt(S rho / p) with d = 550 um: 4.9e-4 at 1 MPa.
  const UnitCell &cell = test::alumina_cell();
  EXPECT_FALSE(
      says(judge(cell, driving, one_megapascal), Kind::not_quasi_static));
  EXPECT_TRUE(
      says(judge(cell, driving, 0.1 * one_megapascal), Kind::not_quasi_static));
}
} // namespace
} // namespace tamp::dem
