// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_extra_loops_h
#define dem_kernel_extra_loops_h

#include <dem/kernel/loops.h>
#include <dem/kernel/transpose.h>

// The loops of laws that most cells do without: contact damping, resistance to
// rolling.
namespace tamp::dem::HWY_NAMESPACE
{
/// Velocity of the surfaces of a pack, second less first [m/s].
template <class T>
Triple<Pack<T>> surface_velocity(const Chunk<T> &chunk, std::size_t k, T rate)
{
  return Pack<T>(rate) * load(chunk.slip_x, chunk.slip_y, chunk.slip_z, k);
}

/// Adds the normal force of damping to that of a chunk.
/// @param rate  1 / time since the memory was written [1/s]
template <class T>
void damp_push(const Viscous &law,
               T rate,
               const ChunkOfBlocks<T> &contacts,
               Chunk<T> &chunk,
               KernelTotals<T> &totals)
{
  using P = Pack<T>;
  P damped(0.0);
  for (std::size_t b = 0; b < contacts.blocks; ++b)
    for (std::size_t lane = 0; lane < lanes<T>; lane += P::size) {
      const std::size_t k = b * lanes<T> + lane;
      const Triple<P> n =
          load(chunk.normal_x, chunk.normal_y, chunk.normal_z, k);
      const P closing = -dot(surface_velocity(chunk, k, rate), n);
      const NormalAnswer<P> push = {
          P::load(chunk.force + k),
          P::load(contacts.after[b].contact_radius + lane),
          P::load(chunk.pull_off + k)};
      const P force = law.normal_force(
          shape_of(contacts.before[b], lane, chunk, k), push, closing);
      force.store(chunk.damping + k);
      (push.force + force).store(chunk.force + k);
      damped += force * closing;
    }
  totals.damped_work += sum(damped) / rate;
}

/// The tangential forces of a chunk with damping, into chunk.rub; those that
/// are remembered into the blocks.
template <class T, class Tangential>
void damp_rub(const void *constants,
              const Viscous &law,
              T rate,
              const ChunkOfBlocks<T> &contacts,
              Chunk<T> &chunk,
              KernelTotals<T> &totals)
{
  using P = Pack<T>;
  P damped(0.0);
  const Tangential tangential = *static_cast<const Tangential *>(constants);
  for (std::size_t b = 0; b < contacts.blocks; ++b)
    for (std::size_t lane = 0; lane < lanes<T>; lane += P::size) {
      const std::size_t k = b * lanes<T> + lane;
      ContactBlock<T> &after = contacts.after[b];
      ViscousMotion<P> now;
      now.pair = shape_of(contacts.before[b], lane, chunk, k);
      now.normal = load(chunk.normal_x, chunk.normal_y, chunk.normal_z, k);
      now.velocity = surface_velocity(chunk, k, rate);
      now.push = {P::load(chunk.force + k),
                  P::load(after.contact_radius + lane),
                  P::load(chunk.pull_off + k)};
      now.force = load(after.force_x, after.force_y, after.force_z, lane);
      now.cap = tangential.cap(now.push);
      now.stiffness = tangential.stiffness(now.push.contact_radius);
      // The whole force is known; its normal damping is in the chunk.
      const P normal = P::load(chunk.damping + k);
      now.push.force -= normal;
      const ViscousAnswer<P> answer = law(now);
      const Triple<P> whole = now.force + answer.force + normal * now.normal;
      store(whole, chunk.rub_x, chunk.rub_y, chunk.rub_z, k);
      store(answer.kept, after.force_x, after.force_y, after.force_z, lane);
      damped += dot(whole - now.force, now.velocity);
    }
  totals.damped_work += sum(damped) / rate;
}

/// Rotations of the grains of a pack, the first less the second.
template <class T>
Triple<Pack<T>> rotation_of(const GrainRow<T> *rows,
                            const ContactBlock<T> &block,
                            std::size_t lane)
{
  constexpr std::size_t width = Pack<T>::size;
  alignas(64) T turn[3][width];
  for (std::size_t l = 0; l < width; ++l) {
    const GrainRow<T> &first = row_at(rows, block.first[lane + l]);
    const GrainRow<T> &second = row_at(rows, block.second[lane + l]);
    for (int a = 0; a < 3; ++a)
      turn[a][l] = first.motion[4 + a] / first.motion[3] -
                   second.motion[4 + a] / second.motion[3];
  }
  return load(turn[0], turn[1], turn[2], 0);
}

/// Adds moments to the torques of the grains.
template <class T>
void add_moments(const Triple<Pack<T>> &moment,
                 const ContactBlock<T> &block,
                 std::size_t lane,
                 GrainRow<T> *rows)
{
  constexpr std::size_t width = Pack<T>::size;
  alignas(64) T m[3][width];
  store(moment, m[0], m[1], m[2], 0);
  for (std::size_t l = 0; l < width; ++l) {
    GrainRow<T> &first = row_at(rows, block.first[lane + l]);
    GrainRow<T> &second = row_at(rows, block.second[lane + l]);
    for (int a = 0; a < 3; ++a) {
      first.force[4 + a] += m[a][l] / first.motion[3];
      second.force[4 + a] -= m[a][l] / second.motion[3];
    }
  }
}

/// Moments of a chunk, which go straight to the grains.
template <class T>
void roll(const Rolling &law,
          const ChunkOfBlocks<T> &contacts,
          const Chunk<T> &chunk,
          GrainRow<T> *rows,
          KernelTotals<T> &totals)
{
  using P = Pack<T>;
  constexpr int moment_rows = 3;
  const std::size_t stride = contacts.more_rows * lanes<T>;
  P lost(0.0);
  for (std::size_t b = 0; b < contacts.blocks; ++b)
    for (std::size_t lane = 0; lane < lanes<T>; lane += P::size) {
      const std::size_t k = b * lanes<T> + lane;
      const ContactBlock<T> &before = contacts.before[b];
      RollingMotion<P> now;
      now.pair = shape_of(before, lane, chunk, k);
      now.normal = load(chunk.normal_x, chunk.normal_y, chunk.normal_z, k);
      now.rotation = rotation_of(rows, before, lane);
      now.spin = P::load(chunk.spin + k);
      now.old_radius = P::load(chunk.old_radius + k);
      now.push = {P::load(chunk.force + k),
                  P::load(contacts.after[b].contact_radius + lane),
                  P::load(chunk.pull_off + k)};
      More<T, moment_rows + Rolling::more> more;
      more.load(contacts.more_before + b * stride, lane);
      const Triple<P> old = {more.value[0], more.value[1], more.value[2]};
      const RollingAnswer<P> answer = law(old, now, more.value + moment_rows);
      const auto touches = now.push.contact_radius > P(0.0);
      more.value[0] = answer.moment.x;
      more.value[1] = answer.moment.y;
      more.value[2] = answer.moment.z;
      for (P &value : more.value)
        value = select(touches, value, P(0.0));
      more.store(contacts.more_after + b * stride, lane);
      add_moments<T>(
          {more.value[0], more.value[1], more.value[2]}, before, lane, rows);
      lost += answer.lost_work;
    }
  totals.lost_work += sum(lost);
}
} // namespace tamp::dem::HWY_NAMESPACE

#endif
