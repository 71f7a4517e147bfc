// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_sweep_h
#define dem_kernel_sweep_h

#include <dem/cell_laws.h>
#include <dem/contact_blocks.h>
#include <dem/grains.h>
#include <dem/kernel/instruction_set.h>
#include <dem/tensors.h>

#include <cstddef>

namespace tamp::dem
{
/// What a sweep does to the contact memory.
enum class Memory {
  frozen, ///< read only: forces of a trial, as in a return mapping
  written ///< the memory becomes that of the present state
};

/// Sums over the contacts of a sweep.
struct SweepTotals {
  double normal_force = 0;  ///< of |N| [N]
  std::size_t contacts = 0; ///< that touch
  bool too_deep = false;    ///< an overlap where no law holds
  double lost_work = 0;     ///< by rubbing and rolling since the memory was
                            ///< written [J]; for written memory only
  double damped_work = 0;   ///< by damping in the contacts [J]
  // Of written memory only:
  double adhesion_loss = 0;  ///< as grains touch and tear [J]
  double forgotten_loss = 0; ///< to yielding, of contacts whose memory is gone
                             ///< and which no measure counts any more [J]
  /// Sum of f (x) l, f the force of the first grain on the second, l the
  /// branch, if asked for [N m].
  Matrix3 moment = Matrix3::Zero();
};

/// The affine part of a motion.
struct AffineMotion {
  /// Of the box since the memory was written: a branch became
  /// stretch branch + motion_j - motion_i [-].
  Matrix3 stretch = Matrix3::Identity();
  double time = 0; ///< since the memory was written, for damping in contacts;
                   ///< 0: none [s]
};

/// What a sweep does.
struct SweepRequest {
  Memory memory = Memory::frozen;
  bool moment = false; ///< whether SweepTotals::moment is wanted
  /// Whether the loops over grains have taken the forces out of the rows, so
  /// that all are zero.
  bool forces_taken = false;
};

/// One pass over all pairs: contact forces and torques from the motions of the
/// grains. Forces in the rows are overwritten, or added to where they were
/// taken. The only hot loop of the room; it does not allocate.
template <class T>
SweepTotals sweep(InstructionSet set,
                  const CellLaws &laws,
                  const AffineMotion &affine,
                  SweepRequest request,
                  GrainRows<T> &rows,
                  ContactBlocks<T> &contacts);
} // namespace tamp::dem

#endif
