// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_transpose_h
#define dem_kernel_transpose_h

#include <dem/grains.h>
#include <dem/kernel/pack.h>

#include <cstdint>

namespace tamp::dem::HWY_NAMESPACE
{
/// A part of eight numbers of a grain's row.
template <class T>
const T *part_of(const GrainRow<T> *rows, std::uint32_t grain, int part)
{
  return reinterpret_cast<const T *>(rows + grain) + 8 * part;
}
template <class T>
T *part_of(GrainRow<T> *rows, std::uint32_t grain, int part)
{
  return reinterpret_cast<T *>(rows + grain) + 8 * part;
}

/// Eight columns: lane l of column c is number c of contact l.
template <class T>
using Columns = Pack<T>[8];

/// Between rows of contacts and columns of numbers, for a register of any
/// width: through memory.
template <class T, std::size_t width>
struct Transpose {
  using P = Pack<T>;

  /// Columns of row(second) - row(first) in the first four numbers and
  /// row(second) + row(first) in the last four.
  static void load(const GrainRow<T> *rows,
                   const std::uint32_t *first,
                   const std::uint32_t *second,
                   int part,
                   Columns<T> &columns)
  {
    alignas(64) T buffer[8][width];
    for (std::size_t l = 0; l < width; ++l) {
      const T *a = part_of(rows, first[l], part);
      const T *b = part_of(rows, second[l], part);
      for (int c = 0; c < 4; ++c)
        buffer[c][l] = b[c] - a[c];
      for (int c = 4; c < 8; ++c)
        buffer[c][l] = b[c] + a[c];
    }
    for (int c = 0; c < 8; ++c)
      columns[c] = P::load(buffer[c]);
  }

  /// Adds the columns to row(first), and to row(second) with the sign of the
  /// first four turned.
  static void add(const Columns<T> &columns,
                  const std::uint32_t *first,
                  const std::uint32_t *second,
                  int part,
                  GrainRow<T> *rows)
  {
    alignas(64) T buffer[8][width];
    for (int c = 0; c < 8; ++c)
      columns[c].store(buffer[c]);
    for (std::size_t l = 0; l < width; ++l) {
      T *a = part_of(rows, first[l], part);
      for (int c = 0; c < 8; ++c)
        a[c] += buffer[c][l];
      T *b = part_of(rows, second[l], part);
      for (int c = 0; c < 4; ++c)
        b[c] -= buffer[c][l];
      for (int c = 4; c < 8; ++c)
        b[c] += buffer[c][l];
    }
  }
};
} // namespace tamp::dem::HWY_NAMESPACE

#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
#include <dem/kernel/transpose_x86.h>
#endif

#endif
