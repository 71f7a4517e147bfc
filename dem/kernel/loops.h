// SPDX|branch| - |old|, withoutSPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_loops_h
#define dem_kernel_loops_h

#include <dem/kernel/ended_contacts.h>
#include <dem/kernel/kernel.h>
#include <dem/kernel/pack.h>

#include <type_traits>

// The loops of a sweep over a chunk of contacts, for the instruction set that
// the file including this is compiled for.
namespace tamp::dem::HWY_NAMESPACE
{
/// Contacts in a block.
template <class T>
constexpr std::size_t lanes = ContactBlock<T>::lanes;

/// Three rows of a chunk or a block, from place k on.
template <class T>
Triple<Pack<T>> load(const T *x, const T *y, const T *z, std::size_t k)
{
  using P = Pack<T>;
  return {P::load(x + k), P::load(y + k), P::load(z + k)};
}
template <class T>
void store(const Triple<Pack<T>> &v, T *x, T *y, T *z, std::size_t k)
{
  v.x.store(x + k);
  v.y.store(y + k);
  v.z.store(z + k);
}

/// The shape of the pairs of a pack.
template <class T>
PairShape<Pack<T>> shape_of(const ContactBlock<T> &block,
                            std::size_t lane,
                            const Chunk<T> &chunk,
                            std::size_t k)
{
  using P = Pack<T>;
  return {P::load(block.radius_sum + lane),
          P::load(block.reduced_radius + lane),
          P::load(chunk.radius_difference + k),
          P::load(chunk.inverse_mass + k)};
}

/// The numbers of a law's own for one pack.
template <class T, int count>
struct More {
  static constexpr int rows = count > 0 ? count : 1;
  Pack<T> value[rows];

  void load(const T *block, std::size_t lane)
  {
    for (int m = 0; m < count; ++m)
      value[m] = Pack<T>::load(block + m * ContactBlock<T>::lanes + lane);
  }
  void store(T *block, std::size_t lane) const
  {
    for (int m = 0; m < count; ++m)
      value[m].store(block + m * ContactBlock<T>::lanes + lane);
  }
};

/// Where a law ends [m]: at 2 R*, unless it says otherwise.
template <class Law, class V>
V deepest_overlap(const Law &law, const PairShape<V> &pair)
{
  if constexpr (requires { law.deepest_overlap(pair); })
    return law.deepest_overlap(pair);
  else
    return V(2.0) * pair.reduced_radius;
}

/// Normal forces of a chunk.
template <class T, class Law>
void push(const void *constants,
          const ChunkOfBlocks<T> &contacts,
          Chunk<T> &chunk,
          KernelTotals<T> &totals)
{
  using P = Pack<T>;
  const Law law = *static_cast<const Law *>(constants);
  const std::size_t stride = contacts.more_rows * lanes<T>;
  [[maybe_unused]] const bool written = contacts.before == contacts.after;
  P force_sum(0.0), touching(0.0), beyond(0.0);
  for (std::size_t b = 0; b < contacts.blocks; ++b)
    for (std::size_t lane = 0; lane < lanes<T>; lane += P::size) {
      const std::size_t k = b * lanes<T> + lane;
      const ContactBlock<T> &before = contacts.before[b];
      ContactBlock<T> &after = contacts.after[b];
      const PairShape<P> pair = shape_of(before, lane, chunk, k);
      const P overlap = P::load(chunk.overlap + k);
      More<T, Law::more> more;
      more.load(contacts.more_before + b * stride, lane);
      const P largest = P::load(before.largest_overlap + lane);
      const P old_radius = P::load(before.contact_radius + lane);
      old_radius.store(chunk.old_radius + k);
      NormalMemory<P> memory = {largest, old_radius, more.value};
      const NormalAnswer<P> answer = law(overlap, pair, memory);

      // A contact is remembered while the grains overlap or stick.
      const auto touches = answer.contact_radius > P(0.0);
      const auto kept = touches | (overlap > P(0.0));
      if constexpr (!std::is_same_v<Law, Hertz>) // which loses nothing
        if (written && any(ends<Law>(largest, old_radius, touches, kept)))
            [[unlikely]]
          book_ends(*static_cast<const Law *>(constants),
                    contacts,
                    chunk,
                    b,
                    lane,
                    answer.contact_radius,
                    totals);
      select(kept, memory.largest_overlap, P(0.0))
          .store(after.largest_overlap + lane);
      answer.contact_radius.store(after.contact_radius + lane);
      for (P &value : more.value)
        value = select(kept, value, P(0.0));
      more.store(contacts.more_after + b * stride, lane);

      answer.force.store(chunk.force + k);
      answer.pull_off.store(chunk.pull_off + k);
      force_sum += abs(answer.force);
      touching += select(touches, P(1.0), P(0.0));
      beyond = max(beyond, overlap - deepest_overlap(law, pair));
    }
  totals.normal_force += sum(force_sum);
  totals.contacts += sum(touching);
  totals.beyond =
      totals.beyond > largest(beyond) ? totals.beyond : largest(beyond);
}

/// Tangential forces of a chunk, and, if booked, the work that is lost.
template <class T, class Law, bool booked>
void rub(const void *constants,
         const ChunkOfBlocks<T> &contacts,
         Chunk<T> &chunk,
         KernelTotals<T> &totals)
{
  using P = Pack<T>;
  const Law law = *static_cast<const Law *>(constants);
  const std::size_t stride = contacts.more_rows * lanes<T>;
  P lost(0.0);
  for (std::size_t b = 0; b < contacts.blocks; ++b)
    for (std::size_t lane = 0; lane < lanes<T>; lane += P::size) {
      const std::size_t k = b * lanes<T> + lane;
      const ContactBlock<T> &before = contacts.before[b];
      ContactBlock<T> &after = contacts.after[b];
      ContactMotion<P> now;
      now.pair = shape_of(before, lane, chunk, k);
      now.normal = load(chunk.normal_x, chunk.normal_y, chunk.normal_z, k);
      now.slip = load(chunk.slip_x, chunk.slip_y, chunk.slip_z, k);
      now.spin = P::load(chunk.spin + k);
      now.old_radius = P::load(chunk.old_radius + k);
      now.push = {P::load(chunk.force + k),
                  P::load(after.contact_radius + lane),
                  P::load(chunk.pull_off + k)};
      const Triple<P> old =
          load(before.force_x, before.force_y, before.force_z, lane);
      More<T, Law::more> more;
      more.load(contacts.more_before + b * stride, lane);
      const TangentialAnswer<P> answer = law(old, now, more.value);

      const auto touches = now.push.contact_radius > P(0.0);
      for (P &value : more.value)
        value = select(touches, value, P(0.0));
      more.store(contacts.more_after + b * stride, lane);
      const auto keep = [&](P value, T *memory) {
        select(touches, value, P(0.0)).store(memory + lane);
      };
      keep(answer.force.x, after.force_x);
      keep(answer.force.y, after.force_y);
      keep(answer.force.z, after.force_z);
      if constexpr (booked)
        lost += answer.lost_work;
    }
  totals.lost_work += sum(lost);
}

} // namespace tamp::dem::HWY_NAMESPACE

#endif
