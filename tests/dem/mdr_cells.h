// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_mdr_cells_h
#define tests_dem_mdr_cells_h

#include <dem/deform.h>
#include <dem/packing.h>
#include <dem/unit_cell.h>

#include <cmath>
#include <gtest/gtest.h>

namespace tamp::dem::test
{
/// 100 granules, 150-250 um, E / Y = 100, mu .3, packed at 0.2 MPa.
inline PackingRequest request_for(NormalLaw law)
{
  PackingRequest request;
  request.grain_count = 100;
  request.sizes.minimum_diameter = 150e-6;
  request.sizes.maximum_diameter = 250e-6;
  request.material = {5e9, 0.3, 1500, 2.75 * 50e6};
  request.contact.normal_law = law;
  request.contact.bulk_onset = 0.3;
  request.goal.pressure = 0.2e6;
  return request;
}

inline const UnitCell &mdr_cell()
{
  static const UnitCell cell = make_packing(request_for(NormalLaw::mdr));
  return cell;
}
inline constexpr double part = 2e-3; // strain of an edge in an increment

/// Presses or relieves a cell isotropically by equal increments; the pressure.
inline double
take_to(UnitCell &cell, double density, const Driving &driving = {})
{
  const double strain = std::log(density / cell.relative_density()) / 3;
  const int parts = int(std::ceil(std::abs(strain) / part - 1e-9));
  double pressure = 0;
  for (int k = 0; k < parts; ++k) {
    const CellAnswer answer =
        deform(cell, std::exp(-strain / parts) * Matrix3::Identity(), driving);
    EXPECT_NE(answer.outcome, Outcome::diverged);
    pressure = -answer.stress.trace() / 3;
  }
  return pressure;
}

/// The cell pressed to a relative density of 0.9, where most grains have grown.
inline const UnitCell &grown_cell()
{
  static const UnitCell cell = [] {
    UnitCell result = mdr_cell();
    take_to(result, 0.9);
    return result;
  }();
  return cell;
}
} // namespace tamp::dem::test

#endif
