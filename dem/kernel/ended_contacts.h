// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_ended_contacts_h
#define dem_kernel_ended_contacts_h

#include <dem/kernel/kernel.h>
#include <dem/kernel/pack.h>
#include <dem/laws/ended_contact.h>

namespace tamp::dem::HWY_NAMESPACE
{
/// Which contacts of a pack begin or end in a way that costs energy: those that
/// are forgotten and, under adhesion, those that touch or tear.
/// @param touches, kept  masks: whether they touch, whether they are remembered
template <class Law, class P>
auto ends(const P &largest_overlap,
          const P &old_radius,
          const auto &touches,
          const auto &kept)
{
  const auto forgotten = (largest_overlap > P(0.0)) & !kept;
  if constexpr (std::is_same_v<Law, Jkr> ||
                std::is_same_v<Law, AdhesiveThorntonNing>) {
    const auto touched = old_radius > P(0.0);
    return forgotten | (touched & !touches) | (touches & !touched);
  } else {
    return forgotten;
  }
}

/// Books what contacts of a pack lose as they begin and end, while `before` is
/// their old memory. They are few: lane by lane, in double.
/// @param b, lane  block of the chunk, and the first lane of the pack
template <class T, class Law>
[[gnu::noinline, gnu::cold]] void book_ends(const Law &law,
                                            const ChunkOfBlocks<T> &contacts,
                                            const Chunk<T> &chunk,
                                            std::size_t b,
                                            std::size_t lane,
                                            const Pack<T> &contact_radius,
                                            KernelTotals<T> &totals)
{
  constexpr std::size_t lanes = ContactBlock<T>::lanes;
  const ContactBlock<T> &before = contacts.before[b];
  alignas(64) T radius[Pack<T>::size];
  contact_radius.store(radius);
  for (std::size_t l = 0; l < Pack<T>::size; ++l) {
    const std::size_t at = lane + l, k = b * lanes + at;
    double more[Law::more + 1] = {};
    for (std::size_t m = 0; m < std::size_t(Law::more); ++m)
      more[m] = contacts.more_before[(b * contacts.more_rows + m) * lanes + at];
    const EndedContact ended =
        end_of(law,
               {before.radius_sum[at],
                before.reduced_radius[at],
                Law::more > 0 ? chunk.radius_difference[k] : T(0), // MDR's
                0},
               {before.largest_overlap[at], before.contact_radius[at], more},
               chunk.overlap[k],
               radius[l]);
    totals.adhesion_loss += T(ended.adhesion);
    totals.forgotten_loss += T(ended.forgotten);
  }
}
} // namespace tamp::dem::HWY_NAMESPACE

#endif
