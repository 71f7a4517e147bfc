// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_packing_h
#define dem_packing_h

#include <dem/compression.h>
#include <dem/deform.h>
#include <dem/grain_material.h>
#include <dem/grain_sizes.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tamp::dem
{
/// A kind of grains of a mixture.
struct GrainPopulation {
  double number_share = 0; ///< of all grains [-]
  GrainSizes sizes;
  GrainMaterial material;
  bool operator==(const GrainPopulation &) const = default;
};

/// What kind of packing is wanted.
struct PackingRequest {
  std::size_t grain_count = 1000;
  GrainSizes sizes;
  GrainMaterial material;
  /// Further kinds of grains in the same cell; the first kind has the rest of
  /// the number. Species k + 1 of the cell is others[k].
  std::vector<GrainPopulation> others;
  ContactModel contact;
  std::uint64_t seed = 1;
  double initial_relative_density = 0.35; ///< of the loose random start [-]
  CompressionGoal goal;
  /// Edge along z over the lateral edges of the loose start [-]; 0: chosen by
  /// cell_shape().
  double edge_ratio = 0;
  /// Damped motion by which grains are packed, under a servo; without, by the
  /// quasi-static map. Isotropic compression to a pressure only.
  std::optional<Dynamics> dynamics;
  /// mu while packing [-]; negative: that of the contact model.
  double friction_during_packing = -1;

  /// Throws std::invalid_argument naming the first value that is not
  /// possible.
  void check() const;
};

/// A jammed periodic packing at equilibrium: grains are put at random without
/// touching, then the cell is compressed to its goal. Deterministic in the
/// request. Throws std::runtime_error if the packing does not jam, and
/// std::invalid_argument as deform().
/// @param observe  see compress(); may be empty
UnitCell make_packing(const PackingRequest &request,
                      const CompressionObserver &observe = {});

/// Compresses a given cell to the goal of the request, with its friction during
/// packing, and hands it over as make_packing() does: without a past, under the
/// request's contact model. Throws std::runtime_error if the goal is not
/// reached.
void finish_packing(UnitCell &cell,
                    const PackingRequest &request,
                    const CompressionObserver &observe = {});
} // namespace tamp::dem

#endif
