// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <tests/dem/sample_cells.h>

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>

namespace tamp::dem
{
namespace
{
// Table I of Sheng et al. (2004) against an independent DEM code driven by slow
// dynamics: 1000 grains, mu .3, p_y 0.5 GPa, mean of two samples. Tolerances
// are the scatter of single samples. Over eight seeds this room finds, at
// 100 kPa, phi .588 +- .004 and Z_m 4.71 +- .04, and axial stresses of
// 6.3 +- .5 MPa at 5 % and 16.6 +- 1.1 MPa at 10 %; the seeds below lie near
// the middle. Its lateral share at 15 % is .49 +- .02, above the other code's.
struct Measured {
  double strain; // engineering, 1 - h / h_0
  double axial;  // [Pa]
  double lateral_share, mechanical_coordination;
  double axial_tolerance; // relative
};
constexpr Measured curve[] = {{0.05, 6.05e6, .57, 5.61, 0.20},
                              {0.10, 16.92e6, .495, 6.17, 0.08},
                              {0.15, 31.90e6, .46, 6.67, 0.08}};
constexpr double share_tolerance = 0.04, coordination_tolerance = 0.15;

struct TableOne : testing::TestWithParam<std::uint64_t> {
};

void expect_packing(const UnitCell &cell)
{
  const CellMeasures found = measure(cell);
  EXPECT_NEAR(-found.stress.trace() / 3, 100e3, 1e3);
  EXPECT_NEAR(found.relative_density, 0.5891, 0.004);
  EXPECT_NEAR(
      found.mechanical_coordination_number, 4.66, coordination_tolerance);
  // Nearly all contacts yield before 100 kPa; .94 and .96 in the two samples.
  EXPECT_NEAR(
      double(found.plastic_contacts) / double(found.contacts), 0.95, 0.05);
}

void expect_state(const UnitCell &cell, const Measured &wanted)
{
  const CellMeasures found = measure(cell);
  const double axial = -found.stress(1, 1);
  const double lateral = -0.5 * (found.stress(0, 0) + found.stress(2, 2));
  EXPECT_NEAR(axial, wanted.axial, wanted.axial_tolerance * wanted.axial);
  EXPECT_NEAR(lateral / axial, wanted.lateral_share, share_tolerance);
  EXPECT_NEAR(found.mechanical_coordination_number,
              wanted.mechanical_coordination,
              coordination_tolerance);
}

TEST_P(TableOne, PackingAndUniaxialCurveAgreeWithAnotherCode)
{
  const UnitCell &packing = test::table_one_cell(GetParam());
  expect_packing(packing);
  UnitCell cell = packing;
  const double height = cell.box.h(1, 1);
  constexpr int steps_per_state = 10; // of 0.5 %
  for (int k = 1; k <= 3 * steps_per_state; ++k) {
    const double wanted = height * (1 - 0.005 * k);
    deform(cell, test::uniaxial(std::log(wanted / cell.box.h(1, 1))), {});
    if (k % steps_per_state == 0) {
      SCOPED_TRACE(testing::Message() << "strain " << 0.005 * k);
      expect_state(cell, curve[k / steps_per_state - 1]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, TableOne, testing::Values(6, 7));
} // namespace
} // namespace tamp::dem
