// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_random_start_h
#define dem_random_start_h

#include <dem/packing.h>
#include <dem/unit_cell.h>

#include <cstdint>
#include <vector>

namespace tamp::dem
{
/// A grain before it has a place.
struct LooseGrain {
  double radius; ///< [m]
  std::uint8_t species;
};

/// The grains of a packing, largest first. Each kind has its share of the
/// number, rounded, and the quantiles of its own sizes.
std::vector<LooseGrain> draw_grains(const PackingRequest &request);

/// Grains at random places of a cell of the shape cell_shape(), none touching:
/// random sequential addition, largest grains first. Throws std::runtime_error
/// if no room is left (relative densities beyond about 0.38).
UnitCell random_start(const PackingRequest &request);
} // namespace tamp::dem

#endif
