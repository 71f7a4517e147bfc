// SPDX-License-Identifier: BSD-3-Clause
#include <dem/laws/ended_contact.h>

#include <variant>

namespace tamp::dem
{
EndedContact end_of(const AnyNormalLaw &any_law,
                    const PairShape<double> &pair,
                    NormalMemory<double> old,
                    double overlap,
                    double contact_radius)
{
  return std::visit(
      [&](const auto &law) {
        EndedContact ended;
        const bool touched = old.contact_radius > 0,
                   touches = contact_radius > 0;
        if (touches && !touched)
          ended.adhesion = law.lost_at_touch(pair, old);
        if (touched && !touches)
          ended.adhesion = law.lost_at_tear(pair, old);
        if (!touches && overlap <= 0 && old.largest_overlap > 0)
          ended.forgotten = law.energy(0, pair, old).dissipated;
        return ended;
      },
      any_law);
}
} // namespace tamp::dem
