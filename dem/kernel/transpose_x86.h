// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_transpose_x86_h
#define dem_kernel_transpose_x86_h

#include <dem/kernel/transpose.h>

namespace tamp::dem::HWY_NAMESPACE
{
// Rows are transposed in registers by exchanges of pairs, of pairs of pairs,
// and so on. A transposition is its own inverse.

#if HWY_TARGET == HWY_AVX3
/// Eight registers of eight doubles.
inline void transpose(Pack<double>::Lanes (&r)[8])
{
  const Pack<double>::Tag d;
  Pack<double>::Lanes pair[8]; // [parity of the column][two rows]
  for (int k = 0; k < 4; ++k) {
    pair[k] = hn::InterleaveLower(d, r[2 * k], r[2 * k + 1]);
    pair[4 + k] = hn::InterleaveUpper(d, r[2 * k], r[2 * k + 1]);
  }
  for (int odd = 0; odd < 2; ++odd) {
    Pack<double>::Lanes near[2], far[2]; // blocks of columns 0, 4 and 2, 6
    for (int k = 0; k < 2; ++k) {
      const auto a = pair[4 * odd + 2 * k], b = pair[4 * odd + 2 * k + 1];
      near[k] = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a);
      far[k] = hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a));
    }
    r[odd] = hn::ConcatLowerLower(d, near[1], near[0]);
    r[odd + 2] = hn::ConcatLowerLower(d, far[1], far[0]);
    r[odd + 4] = hn::ConcatUpperUpper(d, near[1], near[0]);
    r[odd + 6] = hn::ConcatUpperUpper(d, far[1], far[0]);
  }
}

template <>
struct Transpose<double, 8> {
  using P = Pack<double>;

  static P::Lanes signs()
  {
    alignas(64) static constexpr double sign[8] = {-1, -1, -1, -1, 1, 1, 1, 1};
    return hn::Load(P::Tag(), sign);
  }

  static void load(const GrainRow<double> *rows,
                   const std::uint32_t *first,
                   const std::uint32_t *second,
                   int part,
                   Columns<double> &columns)
  {
    const P::Tag d;
    const P::Lanes sign = signs();
    P::Lanes r[8];
    for (int l = 0; l < 8; ++l)
      r[l] = hn::MulAdd(sign,
                        hn::Load(d, part_of(rows, first[l], part)),
                        hn::Load(d, part_of(rows, second[l], part)));
    transpose(r);
    for (int c = 0; c < 8; ++c)
      columns[c] = P(r[c]);
  }

  static void add(const Columns<double> &columns,
                  const std::uint32_t *first,
                  const std::uint32_t *second,
                  int part,
                  GrainRow<double> *rows)
  {
    const P::Tag d;
    const P::Lanes sign = signs();
    P::Lanes r[8];
    for (int c = 0; c < 8; ++c)
      r[c] = columns[c].lanes;
    transpose(r);
    for (int l = 0; l < 8; ++l) {
      double *a = part_of(rows, first[l], part);
      hn::Store(hn::Add(hn::Load(d, a), r[l]), d, a);
      double *b = part_of(rows, second[l], part);
      hn::Store(hn::MulAdd(sign, r[l], hn::Load(d, b)), d, b);
    }
  }
};
#else
/// Four registers of four doubles.
inline void transpose(Pack<double>::Lanes *r)
{
  const Pack<double>::Tag d;
  const auto low01 = hn::InterleaveLower(d, r[0], r[1]);
  const auto high01 = hn::InterleaveUpper(d, r[0], r[1]);
  const auto low23 = hn::InterleaveLower(d, r[2], r[3]);
  const auto high23 = hn::InterleaveUpper(d, r[2], r[3]);
  r[0] = hn::ConcatLowerLower(d, low23, low01);
  r[1] = hn::ConcatLowerLower(d, high23, high01);
  r[2] = hn::ConcatUpperUpper(d, low23, low01);
  r[3] = hn::ConcatUpperUpper(d, high23, high01);
}

template <>
struct Transpose<double, 4> {
  using P = Pack<double>;

  static void load(const GrainRow<double> *rows,
                   const std::uint32_t *first,
                   const std::uint32_t *second,
                   int part,
                   Columns<double> &columns)
  {
    const P::Tag d;
    P::Lanes r[8];
    for (int l = 0; l < 4; ++l) {
      const double *a = part_of(rows, first[l], part);
      const double *b = part_of(rows, second[l], part);
      r[l] = hn::Sub(hn::Load(d, b), hn::Load(d, a));
      r[4 + l] = hn::Add(hn::Load(d, b + 4), hn::Load(d, a + 4));
    }
    transpose(r);
    transpose(r + 4);
    for (int c = 0; c < 8; ++c)
      columns[c] = P(r[c]);
  }

  static void add(const Columns<double> &columns,
                  const std::uint32_t *first,
                  const std::uint32_t *second,
                  int part,
                  GrainRow<double> *rows)
  {
    const P::Tag d;
    P::Lanes r[8];
    for (int c = 0; c < 8; ++c)
      r[c] = columns[c].lanes;
    transpose(r);
    transpose(r + 4);
    for (int l = 0; l < 4; ++l) {
      double *a = part_of(rows, first[l], part);
      hn::Store(hn::Add(hn::Load(d, a), r[l]), d, a);
      hn::Store(hn::Add(hn::Load(d, a + 4), r[4 + l]), d, a + 4);
      double *b = part_of(rows, second[l], part);
      hn::Store(hn::Sub(hn::Load(d, b), r[l]), d, b);
      hn::Store(hn::Add(hn::Load(d, b + 4), r[4 + l]), d, b + 4);
    }
  }
};
#endif

/// Eight by eight floats in each half of the registers, or in the whole of
/// registers of eight.
inline void transpose(Pack<float>::Lanes (&r)[8])
{
  using Lanes = Pack<float>::Lanes;
  const Pack<float>::Tag d;
  const hn::RepartitionToWide<Pack<float>::Tag> wide;
  const auto pairs = [&](Lanes a, Lanes b, bool upper) {
    const auto x = hn::BitCast(wide, a), y = hn::BitCast(wide, b);
    return hn::BitCast(d,
                       upper ? hn::InterleaveUpper(wide, x, y)
                             : hn::InterleaveLower(wide, x, y));
  };
  Lanes quad[2][4]; // [rows 0-3, rows 4-7][columns c and c + 4]
  for (int k = 0; k < 2; ++k) {
    Lanes *q = r + 4 * k;
    const Lanes low01 = hn::InterleaveLower(d, q[0], q[1]);
    const Lanes high01 = hn::InterleaveUpper(d, q[0], q[1]);
    const Lanes low23 = hn::InterleaveLower(d, q[2], q[3]);
    const Lanes high23 = hn::InterleaveUpper(d, q[2], q[3]);
    quad[k][0] = pairs(low01, low23, false);
    quad[k][1] = pairs(low01, low23, true);
    quad[k][2] = pairs(high01, high23, false);
    quad[k][3] = pairs(high01, high23, true);
  }
  for (int c = 0; c < 4; ++c) {
    const Lanes a = quad[0][c], b = quad[1][c];
    r[c] = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a);
    r[c + 4] = hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a));
  }
}

template <std::size_t width>
struct Transpose<float, width> {
  using P = Pack<float>;
  using Tag = hn::CappedTag<float, width>; // that of P
  using Row = hn::CappedTag<float, 8>;
  static constexpr bool two_halves = width == 16;

  static hn::Vec<Row> signs()
  {
    alignas(32) static constexpr float sign[8] = {-1, -1, -1, -1, 1, 1, 1, 1};
    return hn::Load(Row(), sign);
  }

  static void load(const GrainRow<float> *rows,
                   const std::uint32_t *first,
                   const std::uint32_t *second,
                   int part,
                   Columns<float> &columns)
  {
    const auto sign = signs();
    const auto difference = [&](int l) {
      return hn::MulAdd(sign,
                        hn::Load(Row(), part_of(rows, first[l], part)),
                        hn::Load(Row(), part_of(rows, second[l], part)));
    };
    hn::Vec<Tag> r[8];
    for (int l = 0; l < 8; ++l)
      if constexpr (two_halves)
        r[l] = hn::Combine(Tag(), difference(8 + l), difference(l));
      else
        r[l] = difference(l);
    transpose(r);
    for (int c = 0; c < 8; ++c)
      columns[c] = P(r[c]);
  }

  static void add(const Columns<float> &columns,
                  const std::uint32_t *first,
                  const std::uint32_t *second,
                  int part,
                  GrainRow<float> *rows)
  {
    const auto sign = signs();
    const auto add_one = [&](int l, auto row) {
      float *a = part_of(rows, first[l], part);
      hn::Store(hn::Add(hn::Load(Row(), a), row), Row(), a);
      float *b = part_of(rows, second[l], part);
      hn::Store(hn::MulAdd(sign, row, hn::Load(Row(), b)), Row(), b);
    };
    hn::Vec<Tag> r[8];
    for (int c = 0; c < 8; ++c)
      r[c] = columns[c].lanes;
    transpose(r);
    if constexpr (two_halves) {
      for (int l = 0; l < 8; ++l)
        add_one(l, hn::LowerHalf(Row(), r[l]));
      for (int l = 0; l < 8; ++l)
        add_one(8 + l, hn::UpperHalf(Row(), r[l]));
    } else {
      for (int l = 0; l < 8; ++l)
        add_one(l, r[l]);
    }
  }
};
} // namespace tamp::dem::HWY_NAMESPACE

#endif
