// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_transpose_float_h
#define dem_kernel_transpose_float_h

#include <dem/kernel/transpose.h>

// As in transpose_double.h, for registers of eight and sixteen floats.
namespace tamp::dem::HWY_NAMESPACE
{
/// Four by four floats in each block of the registers.
inline void transpose(Pack<float>::Lanes (&r)[4])
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
  const Lanes low01 = hn::InterleaveLower(d, r[0], r[1]);
  const Lanes high01 = hn::InterleaveUpper(d, r[0], r[1]);
  const Lanes low23 = hn::InterleaveLower(d, r[2], r[3]);
  const Lanes high23 = hn::InterleaveUpper(d, r[2], r[3]);
  r[0] = pairs(low01, low23, false);
  r[1] = pairs(low01, low23, true);
  r[2] = pairs(high01, high23, false);
  r[3] = pairs(high01, high23, true);
}

/// Eight by eight floats in each half of registers of sixteen, or in the whole
/// of registers of eight.
inline void transpose(Pack<float>::Lanes (&r)[8])
{
  Pack<float>::Lanes low[4] = {r[0], r[1], r[2], r[3]};
  Pack<float>::Lanes high[4] = {r[4], r[5], r[6], r[7]};
  transpose(low);
  transpose(high);
  for (int c = 0; c < 4; ++c) {
    r[c] = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(high[c]), low[c]);
    r[4 + c] = hn::OddEvenBlocks(high[c], hn::SwapAdjacentBlocks(low[c]));
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

  static void motions(const GrainRow<float> *rows,
                      const std::uint32_t *first,
                      const std::uint32_t *second,
                      Columns<float> &columns)
  {
    const auto sign = signs();
    const auto difference = [&](int l) {
      return hn::MulAdd(sign,
                        hn::Load(Row(), row_at(rows, first[l]).motion),
                        hn::Load(Row(), row_at(rows, second[l]).motion));
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

  static void add_forces(const Columns<float> &columns,
                         const std::uint32_t *first,
                         const std::uint32_t *second,
                         GrainRow<float> *rows)
  {
    const auto sign = signs();
    const auto add = [&](int l, auto what) {
      float *a = row_at(rows, first[l]).force;
      hn::Store(hn::Add(hn::Load(Row(), a), what), Row(), a);
      float *b = row_at(rows, second[l]).force;
      hn::Store(hn::MulAdd(sign, what, hn::Load(Row(), b)), Row(), b);
    };
    hn::Vec<Tag> r[8];
    for (int c = 0; c < 8; ++c)
      r[c] = columns[c].lanes;
    transpose(r);
    if constexpr (two_halves) {
      for (int l = 0; l < 8; ++l)
        add(l, hn::LowerHalf(Row(), r[l]));
      for (int l = 0; l < 8; ++l)
        add(8 + l, hn::UpperHalf(Row(), r[l]));
    } else {
      for (int l = 0; l < 8; ++l)
        add(l, r[l]);
    }
  }
};
} // namespace tamp::dem::HWY_NAMESPACE

#endif
