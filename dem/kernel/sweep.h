// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_sweep_h
#define dem_kernel_sweep_h

#include <dem/contacts.h>
#include <dem/grain_material.h>
#include <dem/grains.h>
#include <dem/tensors.h>

#include <cstddef>
#include <span>

namespace tamp::dem
{
/// What a sweep does to the contact memory.
enum class Memory {
  frozen, ///< read only: forces of a trial, as in a return mapping
  written ///< the memory becomes that of the present state
};

/// Sums over the contacts of a sweep.
struct SweepTotals {
  double normal_force = 0;    ///< [N]
  std::size_t contacts = 0;   ///< that carry a force
  double largest_overlap = 0; ///< over R*, of all contacts [-]
  double slid_work = 0;       ///< dissipated by sliding [J]; written only
  double yielded_work = 0;    ///< dissipated by plasticity [J]; written only
};

/// The affine part of the motion since the memory was written.
struct AffineMotion {
  Matrix3 h;        ///< the box now, edges as columns [m]
  Matrix3 gradient; ///< G, such that the relative displacement of two grains is
                    ///< motion_j - motion_i + G branch [-]
};

/// One pass over all pairs: contact forces and torques from places and
/// motions. Forces in the rows are overwritten. The only hot loop of the room.
using Sweep = SweepTotals (*)(const ContactModel &model,
                              const GrainMaterial &material,
                              const AffineMotion &affine,
                              std::span<GrainRow> rows,
                              std::span<ContactBlock> blocks);

/// The sweep of a combination of laws: chosen once, called often.
Sweep choose_sweep(const ContactModel &model, Memory memory);
} // namespace tamp::dem

#endif
