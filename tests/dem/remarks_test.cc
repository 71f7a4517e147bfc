// SPDX-License-Identifier: BSD-3-Clause
#include <dem/remarks.h>
#include <tests/dem/sample_cells.h>

#include <algorithm>
#include <gtest/gtest.h>

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

const Matrix3 one_megapascal = -1e6 * Matrix3::Identity();

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
