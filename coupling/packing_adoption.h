// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_packing_adoption_h
#define coupling_packing_adoption_h

#include <dem/grain_material.h>

#include <vector>

namespace tamp::dem
{
class UnitCell;
}

namespace tamp::coupling
{
/// What became of the contacts of a stored packing.
enum class History {
  kept,     ///< the packing is as it was stored
  slipped,  ///< only friction is another: contacts slipped where they must
  forgotten ///< other grains or laws: contacts begin with the overlaps now,
            ///< and grains that have grown are as they were
};

/// Puts a stored packing under the materials, one per species, and the contact
/// model of a run, brings it to equilibrium at the same box if these are not
/// its own, and lets the run begin there: without work and last motion. Throws
/// std::invalid_argument if it has more species than there are materials, and
/// std::runtime_error if it does not come to rest.
History adopt_packing(dem::UnitCell &cell,
                      const std::vector<dem::GrainMaterial> &materials,
                      const dem::ContactModel &contact);
} // namespace tamp::coupling

#endif
