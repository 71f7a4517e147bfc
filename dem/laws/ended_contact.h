// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_ended_contact_h
#define dem_laws_ended_contact_h

#include <dem/laws/pair_laws.h>

namespace tamp::dem
{
/// Energy that leaves the accounts of a normal contact at once as it begins or
/// ends [J].
struct EndedContact {
  double adhesion = 0;  ///< lost in the jump of the force, at touch or tear
  double forgotten = 0; ///< taken by yielding before, of a contact whose memory
                        ///< goes: no later measure of the contact counts it
};

/// What an increment of a normal law has ended.
/// @param old  memory before it; the law's own numbers may be written over
/// @param overlap, contact_radius  after it [m]
EndedContact end_of(const AnyNormalLaw &law,
                    const PairShape<double> &pair,
                    NormalMemory<double> old,
                    double overlap,
                    double contact_radius);
} // namespace tamp::dem

#endif
