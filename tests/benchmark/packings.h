// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_benchmark_packings_h
#define tests_benchmark_packings_h

#include <dem/deform.h>
#include <dem/packing.h>
#include <dem/unit_cell.h>

#include <cstddef>
#include <map>

namespace tamp::speed
{
/// Alumina granules of 450 to 650 um that are to be packed at 0.5 MPa.
dem::PackingRequest granules(std::size_t count);

/// The stretch exp(log_strain) along y [-].
dem::Stretch uniaxial(double log_strain);

/// Granules in mid-compaction: packed, then compressed by 5 %.
class Packings
{
public:
  /// Of at most 1000 grains; made when it is first asked for.
  const dem::UnitCell &compacted(std::size_t count);

  /// Of any number of grains: beyond 1000, copies of a smaller cell side by
  /// side, for making a packing is no part of what is measured.
  dem::UnitCell repeated(std::size_t count);

private:
  std::map<std::size_t, dem::UnitCell> made_;
};
} // namespace tamp::speed

#endif
