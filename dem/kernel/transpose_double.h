// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_transpose_double_h
#define dem_kernel_transpose_double_h

#include <dem/kernel/transpose.h>

// Rows are transposed in registers by exchanges of pairs, of pairs of pairs,
// and so on. A transposition is its own inverse.
namespace tamp::dem::HWY_NAMESPACE
{
#if HWY_TARGET == HWY_AVX3
/// Four by four doubles in each half of the registers.
inline void transpose(Pack<double>::Lanes (&r)[4])
{
  const Pack<double>::Tag d;
  const auto even01 = hn::InterleaveLower(d, r[0], r[1]);
  const auto even23 = hn::InterleaveLower(d, r[2], r[3]);
  const auto odd01 = hn::InterleaveUpper(d, r[0], r[1]);
  const auto odd23 = hn::InterleaveUpper(d, r[2], r[3]);
  r[0] = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(even23), even01);
  r[1] = hn::OddEvenBlocks(hn::SwapAdjacentBlocks(odd23), odd01);
  r[2] = hn::OddEvenBlocks(even23, hn::SwapAdjacentBlocks(even01));
  r[3] = hn::OddEvenBlocks(odd23, hn::SwapAdjacentBlocks(odd01));
}

/// Eight registers of eight doubles.
inline void transpose(Pack<double>::Lanes (&r)[8])
{
  const Pack<double>::Tag d;
  Pack<double>::Lanes low[4] = {r[0], r[1], r[2], r[3]};
  Pack<double>::Lanes high[4] = {r[4], r[5], r[6], r[7]};
  transpose(low);
  transpose(high);
  for (int k = 0; k < 4; ++k) {
    r[k] = hn::ConcatLowerLower(d, high[k], low[k]);
    r[4 + k] = hn::ConcatUpperUpper(d, high[k], low[k]);
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

  static void motions(const GrainRow<double> *rows,
                      const std::uint32_t *first,
                      const std::uint32_t *second,
                      Columns<double> &columns)
  {
    const P::Tag d;
    const P::Lanes sign = signs();
    P::Lanes r[8];
    for (int l = 0; l < 8; ++l)
      r[l] = hn::MulAdd(sign,
                        hn::Load(d, row_at(rows, first[l]).motion),
                        hn::Load(d, row_at(rows, second[l]).motion));
    transpose(r);
    for (int c = 0; c < 8; ++c)
      columns[c] = P(r[c]);
  }

  static void add_forces(const Columns<double> &columns,
                         const std::uint32_t *first,
                         const std::uint32_t *second,
                         GrainRow<double> *rows)
  {
    const P::Tag d;
    const P::Lanes sign = signs();
    P::Lanes r[8];
    for (int c = 0; c < 8; ++c)
      r[c] = columns[c].lanes;
    transpose(r);
    for (int l = 0; l < 8; ++l) {
      double *a = row_at(rows, first[l]).force;
      hn::Store(hn::Add(hn::Load(d, a), r[l]), d, a);
      double *b = row_at(rows, second[l]).force;
      hn::Store(hn::MulAdd(sign, r[l], hn::Load(d, b)), d, b);
    }
  }
};
#else
/// Four registers of four doubles.
inline void transpose(Pack<double>::Lanes (&r)[4])
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

  static void motions(const GrainRow<double> *rows,
                      const std::uint32_t *first,
                      const std::uint32_t *second,
                      Columns<double> &columns)
  {
    const P::Tag d;
    P::Lanes low[4], high[4];
    for (int l = 0; l < 4; ++l) {
      const double *a = row_at(rows, first[l]).motion;
      const double *b = row_at(rows, second[l]).motion;
      low[l] = hn::Sub(hn::Load(d, b), hn::Load(d, a));
      high[l] = hn::Add(hn::Load(d, b + 4), hn::Load(d, a + 4));
    }
    transpose(low);
    transpose(high);
    for (int c = 0; c < 4; ++c) {
      columns[c] = P(low[c]);
      columns[4 + c] = P(high[c]);
    }
  }

  static void add_forces(const Columns<double> &columns,
                         const std::uint32_t *first,
                         const std::uint32_t *second,
                         GrainRow<double> *rows)
  {
    const P::Tag d;
    P::Lanes low[4], high[4];
    for (int c = 0; c < 4; ++c) {
      low[c] = columns[c].lanes;
      high[c] = columns[4 + c].lanes;
    }
    transpose(low);
    transpose(high);
    const auto add = [&](double *to, P::Lanes what) {
      hn::Store(hn::Add(hn::Load(d, to), what), d, to);
    };
    for (int l = 0; l < 4; ++l) {
      double *a = row_at(rows, first[l]).force;
      add(a, low[l]);
      add(a + 4, high[l]);
      double *b = row_at(rows, second[l]).force;
      add(b, hn::Neg(low[l]));
      add(b + 4, high[l]);
    }
  }
};
#endif
} // namespace tamp::dem::HWY_NAMESPACE

#endif
