// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_scatter_loops_h
#define dem_kernel_scatter_loops_h

#include <dem/kernel/loops.h>
#include <dem/kernel/transpose.h>

// From the forces of a chunk to the grains and the stress, for the instruction
// set that the file including this is compiled for.
namespace tamp::dem::HWY_NAMESPACE
{
/// Adds the forces and torques of a chunk to the grains.
template <class T, bool damped>
void scatter(const ChunkOfBlocks<T> &contacts,
             const Chunk<T> &chunk,
             GrainRow<T> *rows)
{
  using P = Pack<T>;
  for (std::size_t b = 0; b < contacts.blocks; ++b)
    for (std::size_t lane = 0; lane < lanes<T>; lane += P::size) {
      const std::size_t k = b * lanes<T> + lane;
      const ContactBlock<T> &block = contacts.after[b];
      const Triple<P> n =
          load(chunk.normal_x, chunk.normal_y, chunk.normal_z, k);
      const Triple<P> t =
          damped ? load(chunk.rub_x, chunk.rub_y, chunk.rub_z, k)
                 : load(block.force_x, block.force_y, block.force_z, lane);
      const Triple<P> force = subtract_product(t, P::load(chunk.force + k), n);
      const Triple<P> torque = P::load(chunk.arm + k) * cross(n, t);
      const Columns<T> columns = {force.x,
                                  force.y,
                                  force.z,
                                  P(0.0),
                                  torque.x,
                                  torque.y,
                                  torque.z,
                                  P(0.0)};
      Transpose<T, P::size>::add_forces(columns,
                                        contacts.before[b].first + lane,
                                        contacts.before[b].second + lane,
                                        rows);
    }
}

/// Adds the products of force and branch of a chunk to nine sums.
template <class T, bool damped>
void add_stress(const ChunkOfBlocks<T> &contacts,
                const Chunk<T> &chunk,
                double *sums)
{
  using P = Pack<T>;
  P sum_of[9];
  for (P &value : sum_of)
    value = P(0.0);
  for (std::size_t b = 0; b < contacts.blocks; ++b)
    for (std::size_t lane = 0; lane < lanes<T>; lane += P::size) {
      const std::size_t k = b * lanes<T> + lane;
      const Triple<P> n =
          load(chunk.normal_x, chunk.normal_y, chunk.normal_z, k);
      const ContactBlock<T> &block = contacts.after[b];
      const Triple<P> t =
          damped ? load(chunk.rub_x, chunk.rub_y, chunk.rub_z, k)
                 : load(block.force_x, block.force_y, block.force_z, lane);
      const P distance = P::load(chunk.arm + k) *
                         P::load(contacts.before[b].radius_sum + lane);
      const Triple<P> f = P::load(chunk.force + k) * n - t;
      const Triple<P> l = distance * n;
      const P force[3] = {f.x, f.y, f.z}, branch[3] = {l.x, l.y, l.z};
      for (int a = 0; a < 3; ++a)
        for (int c = 0; c < 3; ++c)
          sum_of[3 * a + c] =
              multiply_add(force[a], branch[c], sum_of[3 * a + c]);
    }
  for (int k = 0; k < 9; ++k)
    sums[k] += double(sum(sum_of[k]));
}
} // namespace tamp::dem::HWY_NAMESPACE

#endif
