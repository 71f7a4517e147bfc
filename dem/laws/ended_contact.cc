// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/ended_contact.h>
#include <dem/laws/pair_laws.h>

namespace tamp::dem
{
template <class Law>
EndedContact end_of(const Law &law,
                    const PairShape<double> &pair,
                    NormalMemory<double> old,
                    double overlap,
                    double contact_radius)
{
  EndedContact ended;
  const bool touched = old.contact_radius > 0, touches = contact_radius > 0;
  if (touches && !touched)
    ended.adhesion = law.lost_at_touch(pair, old);
  if (touched && !touches)
    ended.adhesion = law.lost_at_tear(pair, old);
  if (!touches && overlap <= 0 && old.largest_overlap > 0)
    ended.forgotten = law.energy(0, pair, old).dissipated;
  return ended;
}

// Out of the loops of the kernel, where they would be in the way.
template EndedContact end_of(const Hertz &,
                             const PairShape<double> &,
                             NormalMemory<double>,
                             double,
                             double);
template EndedContact end_of(const ThorntonNing &,
                             const PairShape<double> &,
                             NormalMemory<double>,
                             double,
                             double);
template EndedContact end_of(const Jkr &,
                             const PairShape<double> &,
                             NormalMemory<double>,
                             double,
                             double);
template EndedContact end_of(const AdhesiveThorntonNing &,
                             const PairShape<double> &,
                             NormalMemory<double>,
                             double,
                             double);
template EndedContact end_of(const Storakers &,
                             const PairShape<double> &,
                             NormalMemory<double>,
                             double,
                             double);
template EndedContact end_of(const Mdr &,
                             const PairShape<double> &,
                             NormalMemory<double>,
                             double,
                             double);
} // namespace tamp::dem
