// SPDX-License-Identifier: BSD-3-Clause
#include <dem/deform.h>
#include <tests/benchmark/rows.h>

#include <cstddef>

// The quasi-static map along a path of 1 % of strain in mid-compaction.
namespace tamp::speed
{
namespace
{
using namespace tamp::dem;

constexpr double thousandths = 10; // of strain in a path

/// Where a path in equal parts ends and what it costs.
struct Path {
  Matrix3 stress;
  std::size_t evaluations = 0;
};

Path drive(UnitCell cell, int parts, const Driving &driving)
{
  Path path;
  for (int k = 0; k < parts; ++k) {
    const CellAnswer answer =
        deform(cell, uniaxial(-1e-3 * thousandths / parts), driving);
    path.stress = answer.stress;
    path.evaluations += answer.evaluations;
  }
  return path;
}

/// Error of the stress at the end of the map's path in parts, against slow
/// dynamics, relative to the stress [-].
double stress_error(const UnitCell &cell, int parts)
{
  Driving slow;
  slow.method = Method::dynamics;
  slow.dynamics.strain_rate = 1e-5;
  const Matrix3 wanted = drive(cell, 1, slow).stress;
  return (drive(cell, parts, {}).stress - wanted).norm() / wanted.norm();
}
} // namespace

void add_maps(Packings &packings)
{
  for (std::size_t count : {200, 1000}) {
    const std::string end = of_grains(count);
    add_value("map.evaluations_per_1e-3" + end, evaluations, [=, &packings] {
      return double(drive(packings.compacted(count), 10, {}).evaluations) /
             thousandths;
    });
    add_time(
        "map.seconds_per_1e-3" + end,
        [=, &packings] { drive(packings.compacted(count), 10, {}); },
        thousandths)
        ->Unit(benchmark::kMillisecond);
    add_value("map.stress_error" + end, relative_error, [=, &packings] {
      return stress_error(packings.compacted(count), 10);
    });
    add_value(
        "map.stress_error" + end + ".5e-3", relative_error, [=, &packings] {
          return stress_error(packings.compacted(count), 2);
        });
  }
}
} // namespace tamp::speed
