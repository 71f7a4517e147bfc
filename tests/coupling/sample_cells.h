// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_coupling_sample_cells_h
#define tests_coupling_sample_cells_h

#include <coupling/packing_library.h>
#include <coupling/unit_cell_points.h>
#include <dem/packing.h>

#include <cstddef>
#include <vector>

namespace tamp::coupling::test
{
/// Small cells of soft alumina granules at half a megapascal.
inline dem::PackingRequest granules(std::size_t count = 100)
{
  dem::PackingRequest request;
  request.grain_count = count;
  request.goal.pressure = 0.5e6;
  request.material = {3.5e9, 0.3, 2000, 50e6};
  request.contact.friction_coefficient = 0.35;
  request.sizes.minimum_diameter = 450e-6;
  request.sizes.maximum_diameter = 650e-6;
  return request;
}

/// The packings of the first points of a run.
inline std::vector<dem::UnitCell>
first_packings(const dem::PackingRequest &request, std::size_t count)
{
  std::vector<dem::PackingRequest> samples;
  for (std::size_t i = 0; i < count; ++i)
    samples.push_back(sample_of(request, i));
  return make_packings(samples, 2);
}

/// The packing of point 0 of a run, made once.
inline const dem::UnitCell &sample_cell()
{
  static const dem::UnitCell cell = make_packing(sample_of(granules(), 0));
  return cell;
}

/// Grains of the law mdr at a relative density at which they grow, made once.
inline const dem::UnitCell &growing_cell()
{
  static const dem::UnitCell cell = [] {
    dem::PackingRequest request = granules();
    request.contact.normal_law = dem::NormalLaw::mdr;
    request.contact.bulk_onset = 0.4;
    dem::UnitCell result = make_packing(request);
    while (result.relative_density() < 0.85)
      deform(result, 0.997 * dem::Matrix3::Identity(), {});
    return result;
  }();
  return cell;
}

/// Granules whose limiting contact pressure rises steeply with the density,
/// made once.
inline const dem::UnitCell &adjusted_cell()
{
  static const dem::UnitCell cell = [] {
    dem::PackingRequest request = granules();
    request.contact.normal_law = dem::NormalLaw::thornton_ning_adjusted;
    request.material.adjusted_pressures = {{0.58, 20e6}, {0.64, 200e6}};
    return make_packing(request);
  }();
  return cell;
}

/// A uniaxial increment.
inline fem::Deformation pressed(double strain)
{
  fem::Deformation deformation;
  deformation.relative_F[0][0] = deformation.relative_F[1][1] = 1;
  deformation.relative_F[2][2] = 1 - strain;
  return deformation;
}

inline CellPointsOptions cold()
{
  CellPointsOptions options;
  options.warm = false;
  return options;
}

inline std::vector<dem::UnitCell> same_cells(std::size_t count)
{
  return std::vector<dem::UnitCell>(count, sample_cell());
}

/// Different packings, made once for all tests.
inline std::vector<dem::UnitCell> different_cells(std::size_t count)
{
  static std::vector<dem::UnitCell> cells;
  if (cells.size() < count)
    cells = first_packings(granules(), count);
  return {cells.begin(), cells.begin() + std::ptrdiff_t(count)};
}
} // namespace tamp::coupling::test

#endif
