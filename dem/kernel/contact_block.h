// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_contact_block_h
#define dem_kernel_contact_block_h

#include <cstddef>
#include <cstdint>

namespace tamp::dem
{
/// Sixteen pairs as the sweep sees them: what is constant while the list of
/// pairs stands, then the memory of the grains and of their contact. The same
/// on every instruction set, so that files and the order in which forces are
/// added to a grain never depend on the width of a register.
template <class T>
struct alignas(64) ContactBlock {
  static constexpr std::size_t lanes = 16;
  std::uint32_t first[lanes], second[lanes]; ///< row_offset() of the grains
  T radius_sum[lanes];                       ///< R_i + R_j [m]
  T inverse_sum[lanes];                      ///< 1 / (R_i + R_j) [1/m]
  T reduced_radius[lanes];                   ///< R* [m]
  T branch_x[lanes], branch_y[lanes],
      branch_z[lanes]; ///< when the memory was written [m]
  T overlap[lanes];    ///< [m]
  T force_x[lanes], force_y[lanes], force_z[lanes]; ///< tangential [N]
  T largest_overlap[lanes];                         ///< [m]
  T contact_radius[lanes];                          ///< [m]
};

/// A hundred and twenty-eight contacts on their way through the loops of a
/// sweep, small enough to stay in the innermost cache.
template <class T>
struct alignas(64) Chunk {
  static constexpr std::size_t blocks = 8;
  static constexpr std::size_t size = blocks * ContactBlock<T>::lanes;
  T normal_x[size], normal_y[size], normal_z[size]; ///< n [-]
  T overlap[size];                                  ///< [m]
  T arm[size]; ///< distance of the centres over R_i + R_j [-]
  T slip_x[size], slip_y[size], slip_z[size]; ///< of the surfaces [m]
  T spin[size];                               ///< about n [rad]
  T radius_difference[size];                  ///< R_j - R_i [m]
  T inverse_mass[size];                       ///< 1/m* [1/kg]
  T force[size];                              ///< N [N]
  T old_radius[size];                         ///< a before [m]
  T pull_off[size];                           ///< N_c [N]
  // With contact damping only:
  T damping[size];                         ///< its part of N [N]
  T rub_x[size], rub_y[size], rub_z[size]; ///< T with damping [N]
};
} // namespace tamp::dem

#endif
