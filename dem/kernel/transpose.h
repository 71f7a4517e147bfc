// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_transpose_h
#define dem_kernel_transpose_h

#include <dem/grains.h>
#include <dem/kernel/pack.h>

#include <cstddef>
#include <cstdint>

namespace tamp::dem::HWY_NAMESPACE
{
/// The row of a grain, by its row_offset().
template <class T>
const GrainRow<T> &row_at(const GrainRow<T> *rows, std::uint32_t offset)
{
  return *reinterpret_cast<const GrainRow<T> *>(
      reinterpret_cast<const std::byte *>(rows) + offset);
}
template <class T>
GrainRow<T> &row_at(GrainRow<T> *rows, std::uint32_t offset)
{
  return *reinterpret_cast<GrainRow<T> *>(reinterpret_cast<std::byte *>(rows) +
                                          offset);
}

/// Lane l of column c is number c of contact l.
template <class T>
using Columns = Pack<T>[8];

/// Between rows of grains and columns of contacts, for a register of any width:
/// through memory.
template <class T, std::size_t width>
struct Transpose {
  using P = Pack<T>;

  /// Columns of motion(second) - motion(first) in the first four numbers and of
  /// their sums in the last four.
  static void motions(const GrainRow<T> *rows,
                      const std::uint32_t *first,
                      const std::uint32_t *second,
                      Columns<T> &columns)
  {
    alignas(64) T buffer[8][width];
    for (std::size_t l = 0; l < width; ++l) {
      const T *a = row_at(rows, first[l]).motion;
      const T *b = row_at(rows, second[l]).motion;
      for (int c = 0; c < 4; ++c)
        buffer[c][l] = b[c] - a[c];
      for (int c = 4; c < 8; ++c)
        buffer[c][l] = b[c] + a[c];
    }
    for (int c = 0; c < 8; ++c)
      columns[c] = P::load(buffer[c]);
  }

  /// Adds the columns to force(first), and to force(second) with the sign of
  /// the first four turned.
  static void add_forces(const Columns<T> &columns,
                         const std::uint32_t *first,
                         const std::uint32_t *second,
                         GrainRow<T> *rows)
  {
    alignas(64) T buffer[8][width];
    for (int c = 0; c < 8; ++c)
      columns[c].store(buffer[c]);
    for (std::size_t l = 0; l < width; ++l) {
      T *a = row_at(rows, first[l]).force;
      for (int c = 0; c < 8; ++c)
        a[c] += buffer[c][l];
      T *b = row_at(rows, second[l]).force;
      for (int c = 0; c < 4; ++c)
        b[c] -= buffer[c][l];
      for (int c = 4; c < 8; ++c)
        b[c] += buffer[c][l];
    }
  }
};
} // namespace tamp::dem::HWY_NAMESPACE

#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
#include <dem/kernel/transpose_double.h>
#include <dem/kernel/transpose_float.h>
#endif

#endif
