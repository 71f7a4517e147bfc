// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_gather_loop_h
#define dem_kernel_gather_loop_h

#include <dem/kernel/loops.h>
#include <dem/kernel/transpose.h>

#include <type_traits>

// From the motions of grains to the branches and slips of contacts, for the
// instruction set that the file including this is compiled for.
namespace tamp::dem::HWY_NAMESPACE
{
/// matrix v + w.
template <class P>
Triple<P>
multiply_add(const P (&matrix)[9], const Triple<P> &v, const Triple<P> &w)
{
  const auto row = [&](int a, P sum) {
    sum = multiply_add(matrix[a], v.x, sum);
    sum = multiply_add(matrix[a + 1], v.y, sum);
    return multiply_add(matrix[a + 2], v.z, sum);
  };
  return {row(0, w.x), row(3, w.y), row(6, w.z)};
}

/// The overlap now: R_i + R_j less the distance; in single precision the old
/// one less the growth of the branch, without cancellation.
/// @param sum  of the old branch and the new
template <class T>
Pack<T> overlap_of(const ContactBlock<T> &block,
                   std::size_t lane,
                   const Triple<Pack<T>> &sum,
                   const Triple<Pack<T>> &change,
                   const Pack<T> &distance)
{
  const Pack<T> radii = Pack<T>::load(block.radius_sum + lane);
  if constexpr (std::is_same_v<T, float>) {
    const Pack<T> before = Pack<T>::load(block.overlap + lane);
    return before - dot(sum, change) / (distance + (radii - before));
  } else {
    return radii - distance;
  }
}

/// Geometry and relative motion of all pairs of a chunk, and what the laws of
/// some pairs want to know of the two grains.
template <class T, bool with_grains>
void gather(const GrainRow<T> *rows,
            const AffineLanes<T> &affine,
            const ChunkOfBlocks<T> &contacts,
            Chunk<T> &chunk)
{
  using P = Pack<T>;
  P growth[9];
  for (int k = 0; k < 9; ++k)
    growth[k] = P(affine.growth[k]);
  for (std::size_t b = 0; b < contacts.blocks; ++b)
    for (std::size_t lane = 0; lane < lanes<T>; lane += P::size) {
      const std::size_t k = b * lanes<T> + lane;
      const ContactBlock<T> &block = contacts.before[b];
      Columns<T> motion;
      Transpose<T, P::size>::motions(
          rows, block.first + lane, block.second + lane, motion);

      const Triple<P> old =
          load(block.branch_x, block.branch_y, block.branch_z, lane);
      const Triple<P> change =
          multiply_add(growth, old, {motion[0], motion[1], motion[2]});
      const Triple<P> branch = old + change;
      const P distance = sqrt(dot(branch, branch));
      const P overlap = overlap_of(block, lane, old + branch, change, distance);
      const Triple<P> n = (P(1.0) / distance) * branch;
      const P inverse_sum = P::load(block.inverse_sum + lane);
      const P arm = distance * inverse_sum;
      const Triple<P> turn =
          inverse_sum * Triple<P>{motion[4], motion[5], motion[6]};
      // About the branch half way, a turn of the whole pair is no slip.
      const Triple<P> middle = multiply_add(P(0.5), change, old);
      const Triple<P> slip = change - cross(turn, middle);
      const P spin = dot(turn, n);

      ContactBlock<T> &after = contacts.after[b];
      store(branch, after.branch_x, after.branch_y, after.branch_z, lane);
      overlap.store(after.overlap + lane);
      store(n, chunk.normal_x, chunk.normal_y, chunk.normal_z, k);
      overlap.store(chunk.overlap + k);
      arm.store(chunk.arm + k);
      store(slip, chunk.slip_x, chunk.slip_y, chunk.slip_z, k);
      spin.store(chunk.spin + k);
      if constexpr (with_grains) {
        motion[3].store(chunk.radius_difference + k);
        motion[7].store(chunk.inverse_mass + k);
      }
    }
}

} // namespace tamp::dem::HWY_NAMESPACE

#endif
