// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_packing_h
#define dem_packing_h

#include <dem/grain_material.h>
#include <dem/grain_sizes.h>

#include <cstddef>
#include <cstdint>

namespace tamp::dem
{
class UnitCell;

/// What kind of packing is wanted.
struct PackingRequest {
  std::size_t grain_count = 1000;
  GrainSizes sizes;
  GrainMaterial material;
  ContactModel contact;
  std::uint64_t seed = 1;
  double initial_relative_density = 0.35; ///< of the loose random start [-]
  double pressure = 100e3;                ///< to compress to [Pa]
  /// mu while packing [-]; negative: that of the contact model.
  double friction_during_packing = -1;

  /// Throws std::invalid_argument naming the first value that is not
  /// possible.
  void check() const;
};

/// A jammed periodic packing at equilibrium under an isotropic pressure: grains
/// are put at random without touching, then the cell is compressed
/// isotropically until the mean stress is `pressure` (within 1 %).
/// Deterministic in the request. Throws std::runtime_error if the packing does
/// not jam.
UnitCell make_packing(const PackingRequest &request);
} // namespace tamp::dem

#endif
