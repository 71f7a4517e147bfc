// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_loops_h
#define dem_kernel_loops_h

#include <dem/kernel/kernel.h>
#include <dem/kernel/pack.h>
#include <dem/kernel/transpose.h>

#include <type_traits>
#include <utility>

// The loops of a sweep over a chunk of contacts, for the instruction set that
// the file including this is compiled for.
namespace tamp::dem::HWY_NAMESPACE
{
/// Calls `visit(block, lane, k)` for every pack of a chunk: lane is that of the
/// block where the pack begins, k its place in the chunk.
template <class T, class Visitor>
void for_each_pack(std::size_t blocks, Visitor &&visit)
{
  constexpr std::size_t lanes = ContactBlock<T>::lanes;
  for (std::size_t b = 0; b < blocks; ++b)
    for (std::size_t lane = 0; lane < lanes; lane += Pack<T>::size)
      visit(b, lane, b * lanes + lane);
}

template <class P>
Triple<P> times(const P (&matrix)[9], const Triple<P> &v)
{
  const auto row = [&](int a) {
    return multiply_add(
        matrix[3 * a],
        v.x,
        multiply_add(matrix[3 * a + 1], v.y, matrix[3 * a + 2] * v.z));
  };
  return {row(0), row(1), row(2)};
}

/// Geometry and relative motion of all pairs of a chunk.
template <class T>
void gather(const GrainRow<T> *rows,
            const AffineLanes<T> &affine,
            const ChunkOfBlocks<T> &contacts,
            Chunk<T> &chunk)
{
  using P = Pack<T>;
  P stretch[9], gradient[9];
  for (int k = 0; k < 9; ++k) {
    stretch[k] = P(affine.stretch[k]);
    gradient[k] = P(affine.gradient[k]);
  }
  for_each_pack<T>(
      contacts.blocks, [&](std::size_t b, std::size_t lane, std::size_t k) {
        const ContactBlock<T> &block = contacts.before[b];
        Columns<T> place, motion;
        using Rows = Transpose<T, P::size>;
        const std::uint32_t *first = block.first + lane;
        const std::uint32_t *second = block.second + lane;
        Rows::load(rows, first, second, 0, place);
        Rows::load(rows, first, second, 1, motion);

        const Triple<P> listed = {P::load(block.branch_x + lane),
                                  P::load(block.branch_y + lane),
                                  P::load(block.branch_z + lane)};
        const Triple<P> change =
            Triple<P>{place[0], place[1], place[2]} + times(stretch, listed);
        const Triple<P> branch = listed + change;
        const P distance = sqrt(dot(branch, branch));
        const P sum = P::load(block.radius_sum + lane);
        P overlap;
        if constexpr (std::is_same_v<T, float>) {
          // |listed| - |branch| without cancellation.
          const P before = P::load(block.overlap + lane);
          overlap = before -
                    dot(listed + branch, change) / (distance + (sum - before));
        } else {
          overlap = sum - distance;
        }
        const Triple<P> n = (P(1.0) / distance) * branch;
        const P arm = distance / sum;
        const Triple<P> rolled = {motion[4], motion[5], motion[6]};
        const Triple<P> slip = Triple<P>{motion[0], motion[1], motion[2]} +
                               times(gradient, branch) - arm * cross(rolled, n);
        const P spin = P(0.5) * dot(Triple<P>{place[4], place[5], place[6]}, n);

        n.x.store(chunk.normal_x + k);
        n.y.store(chunk.normal_y + k);
        n.z.store(chunk.normal_z + k);
        overlap.store(chunk.overlap + k);
        arm.store(chunk.arm + k);
        slip.x.store(chunk.slip_x + k);
        slip.y.store(chunk.slip_y + k);
        slip.z.store(chunk.slip_z + k);
        spin.store(chunk.spin + k);
        place[3].store(chunk.radius_difference + k);
        place[7].store(chunk.inverse_mass + k);
      });
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

/// Normal forces of a chunk.
template <class T, class Law>
void push(const void *constants,
          const ChunkOfBlocks<T> &contacts,
          Chunk<T> &chunk,
          KernelTotals<T> &totals)
{
  using P = Pack<T>;
  const Law law = *static_cast<const Law *>(constants);
  const std::size_t stride = contacts.more_rows * ContactBlock<T>::lanes;
  P force_sum(0.0), touching(0.0), beyond(0.0);
  for_each_pack<T>(
      contacts.blocks, [&](std::size_t b, std::size_t lane, std::size_t k) {
        const ContactBlock<T> &before = contacts.before[b];
        ContactBlock<T> &after = contacts.after[b];
        const PairShape<P> pair = shape_of(before, lane, chunk, k);
        const P overlap = P::load(chunk.overlap + k);
        More<T, Law::more> more;
        more.load(contacts.more_before + b * stride, lane);
        NormalMemory<P> memory = {P::load(before.largest_overlap + lane),
                                  P::load(before.contact_radius + lane),
                                  more.value};
        const NormalAnswer<P> answer = law(overlap, pair, memory);

        // A contact is remembered while the grains overlap or stick.
        const auto touches = answer.contact_radius > P(0.0);
        const auto kept = touches | (overlap > P(0.0));
        select(kept, memory.largest_overlap, P(0.0))
            .store(after.largest_overlap + lane);
        answer.contact_radius.store(after.contact_radius + lane);
        for (P &value : more.value)
          value = select(kept, value, P(0.0));
        more.store(contacts.more_after + b * stride, lane);

        answer.force.store(chunk.force + k);
        answer.contact_radius.store(chunk.contact_radius + k);
        answer.pull_off.store(chunk.pull_off + k);
        force_sum += abs(answer.force);
        touching += select(touches, P(1.0), P(0.0));
        beyond = max(beyond, overlap - P(2.0) * pair.reduced_radius);
      });
  totals.normal_force += sum(force_sum);
  totals.contacts += sum(touching);
  totals.beyond =
      totals.beyond > largest(beyond) ? totals.beyond : largest(beyond);
}

/// Tangential forces of a chunk.
template <class T, class Law>
void rub(const void *constants,
         const ChunkOfBlocks<T> &contacts,
         Chunk<T> &chunk,
         KernelTotals<T> &totals)
{
  using P = Pack<T>;
  const Law law = *static_cast<const Law *>(constants);
  const std::size_t stride = contacts.more_rows * ContactBlock<T>::lanes;
  P lost(0.0);
  for_each_pack<T>(
      contacts.blocks, [&](std::size_t b, std::size_t lane, std::size_t k) {
        const ContactBlock<T> &before = contacts.before[b];
        ContactBlock<T> &after = contacts.after[b];
        const auto triple = [](const T *x, const T *y, const T *z) {
          return Triple<P>{P::load(x), P::load(y), P::load(z)};
        };
        ContactMotion<P> now;
        now.pair = shape_of(before, lane, chunk, k);
        now.normal =
            triple(chunk.normal_x + k, chunk.normal_y + k, chunk.normal_z + k);
        now.slip = triple(chunk.slip_x + k, chunk.slip_y + k, chunk.slip_z + k);
        now.spin = P::load(chunk.spin + k);
        now.old_radius = P::load(before.contact_radius + lane);
        now.push = {P::load(chunk.force + k),
                    P::load(chunk.contact_radius + k),
                    P::load(chunk.pull_off + k)};
        const Triple<P> old = triple(before.force_x + lane,
                                     before.force_y + lane,
                                     before.force_z + lane);
        More<T, Law::more> more;
        more.load(contacts.more_before + b * stride, lane);
        const TangentialAnswer<P> answer = law(old, now, more.value);

        const auto touches = now.push.contact_radius > P(0.0);
        for (P &value : more.value)
          value = select(touches, value, P(0.0));
        more.store(contacts.more_after + b * stride, lane);
        const auto keep = [&](P value, T *memory, T *in_chunk) {
          const P kept = select(touches, value, P(0.0));
          kept.store(memory);
          kept.store(in_chunk);
        };
        keep(answer.force.x, after.force_x + lane, chunk.rub_x + k);
        keep(answer.force.y, after.force_y + lane, chunk.rub_y + k);
        keep(answer.force.z, after.force_z + lane, chunk.rub_z + k);
        lost += select(touches, answer.lost_work, P(0.0));
      });
  totals.lost_work += sum(lost);
}

/// Adds the forces and torques of a chunk to the grains.
template <class T>
void scatter(const ChunkOfBlocks<T> &contacts,
             const Chunk<T> &chunk,
             GrainRow<T> *rows)
{
  using P = Pack<T>;
  for_each_pack<T>(
      contacts.blocks, [&](std::size_t b, std::size_t lane, std::size_t k) {
        const Triple<P> n = {P::load(chunk.normal_x + k),
                             P::load(chunk.normal_y + k),
                             P::load(chunk.normal_z + k)};
        const Triple<P> t = {P::load(chunk.rub_x + k),
                             P::load(chunk.rub_y + k),
                             P::load(chunk.rub_z + k)};
        const Triple<P> force = t - P::load(chunk.force + k) * n;
        const Triple<P> torque = P::load(chunk.arm + k) * cross(n, t);
        const Columns<T> columns = {force.x,
                                    force.y,
                                    force.z,
                                    P(0.0),
                                    torque.x,
                                    torque.y,
                                    torque.z,
                                    P(0.0)};
        Transpose<T, P::size>::add(columns,
                                   contacts.before[b].first + lane,
                                   contacts.before[b].second + lane,
                                   2,
                                   rows);
      });
}

template <class T>
void add_stress(const ChunkOfBlocks<T> &contacts,
                const Chunk<T> &chunk,
                double *sums)
{
  using P = Pack<T>;
  P sum_of[9];
  for (P &value : sum_of)
    value = P(0.0);
  for_each_pack<T>(
      contacts.blocks, [&](std::size_t b, std::size_t lane, std::size_t k) {
        const Triple<P> n = {P::load(chunk.normal_x + k),
                             P::load(chunk.normal_y + k),
                             P::load(chunk.normal_z + k)};
        const Triple<P> t = {P::load(chunk.rub_x + k),
                             P::load(chunk.rub_y + k),
                             P::load(chunk.rub_z + k)};
        const P distance = P::load(chunk.arm + k) *
                           P::load(contacts.before[b].radius_sum + lane);
        const Triple<P> f = P::load(chunk.force + k) * n - t;
        const Triple<P> l = distance * n;
        const P force[3] = {f.x, f.y, f.z}, branch[3] = {l.x, l.y, l.z};
        for (int a = 0; a < 3; ++a)
          for (int c = 0; c < 3; ++c)
            sum_of[3 * a + c] =
                multiply_add(force[a], branch[c], sum_of[3 * a + c]);
      });
  for (int k = 0; k < 9; ++k)
    sums[k] += double(sum(sum_of[k]));
}

template <class T, std::size_t... normal, std::size_t... tangential>
constexpr KernelLoops<T> all_loops(std::index_sequence<normal...>,
                                   std::index_sequence<tangential...>)
{
  return {gather<T>,
          {push<T, std::variant_alternative_t<normal, AnyNormalLaw>>...},
          {rub<T, std::variant_alternative_t<tangential, AnyTangentialLaw>>...},
          scatter<T>,
          add_stress<T>};
}

template <class T>
constexpr KernelLoops<T> all_loops()
{
  return all_loops<T>(
      std::make_index_sequence<std::variant_size_v<AnyNormalLaw>>(),
      std::make_index_sequence<std::variant_size_v<AnyTangentialLaw>>());
}

/// The kernel of this instruction set.
inline constexpr Kernel kernel = {all_loops<double>(), all_loops<float>()};
} // namespace tamp::dem::HWY_NAMESPACE

#endif
