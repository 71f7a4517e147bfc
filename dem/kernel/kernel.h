// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_kernel_h
#define dem_kernel_kernel_h

#include <dem/grains.h>
#include <dem/kernel/contact_block.h>
#include <dem/kernel/grain_motion.h>
#include <dem/kernel/near_pairs.h>
#include <dem/laws/pair_laws.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <variant>

namespace tamp::dem
{
/// The affine part of a motion, as rows of a 3 x 3 matrix.
template <class T>
struct AffineLanes {
  T growth[9]; ///< stretch since the contact memory was written, less I [-]
  T rate;      ///< 1 / time since then; 0: no time counts [1/s]
};

/// Sums over the contacts of a sweep.
template <class T>
struct KernelTotals {
  T normal_force = 0; ///< sum of |N| [N]
  T contacts = 0;     ///< that touch
  T beyond = 0;       ///< above zero if an overlap is beyond its law [m]
  T lost_work = 0;    ///< by the tangential and rolling laws [J]
  T damped_work = 0;  ///< by contact damping [J]
  // Of written memory only:
  T adhesion_loss = 0;  ///< as grains touch and tear [J]
  T forgotten_loss = 0; ///< to yielding, of contacts that are forgotten [J]
};

/// The blocks of one kind of pairs: memory is read from `before` and written to
/// `after`, which may be the same. `more` are the laws' own numbers, in rows of
/// ContactBlock::lanes.
template <class T>
struct ChunkOfBlocks {
  std::size_t blocks; ///< 1 to Chunk::blocks
  const ContactBlock<T> *before;
  ContactBlock<T> *after;
  const T *more_before;
  T *more_after;
  std::size_t more_rows; ///< of each block

  /// The same, with the numbers of the first `rows` rows left out.
  ChunkOfBlocks past(std::size_t rows) const
  {
    ChunkOfBlocks result = *this;
    result.more_before += rows * ContactBlock<T>::lanes;
    result.more_after += rows * ContactBlock<T>::lanes;
    return result;
  }
};

/// The loops of a sweep over one chunk, in their order. A law is that of
/// PairLaws whose index in the list of laws the loop has.
template <class T>
struct KernelLoops {
  static constexpr std::size_t normal_laws = std::variant_size_v<AnyNormalLaw>;
  static constexpr std::size_t tangential_laws =
      std::variant_size_v<AnyTangentialLaw>;

  using Gather = void (*)(const GrainRow<T> *rows,
                          const AffineLanes<T> &affine,
                          const ChunkOfBlocks<T> &contacts,
                          Chunk<T> &chunk);
  using Law = void (*)(const void *law,
                       const ChunkOfBlocks<T> &contacts,
                       Chunk<T> &chunk,
                       KernelTotals<T> &totals);
  using DampPush = void (*)(const Viscous &law,
                            T rate,
                            const ChunkOfBlocks<T> &contacts,
                            Chunk<T> &chunk,
                            KernelTotals<T> &totals);
  using DampRub = void (*)(const void *tangential_law,
                           const Viscous &law,
                           T rate,
                           const ChunkOfBlocks<T> &contacts,
                           Chunk<T> &chunk,
                           KernelTotals<T> &totals);
  using Scatter = void (*)(const ChunkOfBlocks<T> &contacts,
                           const Chunk<T> &chunk,
                           GrainRow<T> *rows);
  using Roll = void (*)(const Rolling &law,
                        const ChunkOfBlocks<T> &contacts,
                        const Chunk<T> &chunk,
                        GrainRow<T> *rows,
                        KernelTotals<T> &totals);
  /// Adds sum f_a l_b of the chunk, f the force of the first grain on the
  /// second, to nine sums.
  using Stress = void (*)(const ChunkOfBlocks<T> &contacts,
                          const Chunk<T> &chunk,
                          double *sums);

  Gather gather;
  Gather gather_with_grains; ///< masses and radii, too
  std::array<Law, normal_laws> normal;
  DampPush damp_push; ///< only with damping
  std::array<Law, tangential_laws> tangential;
  std::array<Law, tangential_laws> booked_tangential; ///< with lost work
  std::array<DampRub, tangential_laws> damp_rub;      ///< only with damping
  Scatter scatter;
  Scatter scatter_damped; ///< after damp_rub
  Roll roll;              ///< only with a rolling law
  Stress stress;          ///< only if wanted
  Stress stress_damped;
  GrainLoops<T> grains;
};

/// All loops, compiled for one instruction set.
struct Kernel {
  KernelLoops<double> in_double;
  KernelLoops<float> in_float;
  PairLoops pairs;

  template <class T>
  const KernelLoops<T> &loops() const
  {
    if constexpr (std::is_same_v<T, double>)
      return in_double;
    else
      return in_float;
  }
};
} // namespace tamp::dem

#endif
