// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_grain_row_pack_h
#define dem_kernel_grain_row_pack_h

#include <dem/kernel/pack.h>

#include <cstddef>

namespace tamp::dem::HWY_NAMESPACE
{
/// Eight doubles in as many registers as it takes.
class RowPack
{
public:
  using P = Pack<double>;
  static constexpr std::size_t lanes = P::size, parts = 8 / lanes;
  using Narrow = hn::Rebind<float, P::Tag>;

  P part[parts];

  RowPack() = default;
  explicit RowPack(double value)
  {
    for (P &p : part)
      p = P(value);
  }
  /// The first four numbers a, the last four b.
  static RowPack halves(double a, double b)
  {
    RowPack row;
#if HWY_TARGET == HWY_AVX3
    const hn::Half<P::Tag> half;
    row.part[0] = P(hn::Combine(P::Tag(), hn::Set(half, b), hn::Set(half, a)));
#else
    for (std::size_t k = 0; k < parts; ++k)
      row.part[k] = P(k < parts / 2 ? a : b);
#endif
    return row;
  }
  static RowPack load(const double *from)
  {
    RowPack row;
    for (std::size_t k = 0; k < parts; ++k)
      row.part[k] = P::load(from + k * lanes);
    return row;
  }
  static RowPack load(const float *from)
  {
    RowPack row;
    for (std::size_t k = 0; k < parts; ++k)
      row.part[k] =
          P(hn::PromoteTo(P::Tag(), hn::Load(Narrow(), from + k * lanes)));
    return row;
  }
  void store(double *to) const
  {
    for (std::size_t k = 0; k < parts; ++k)
      part[k].store(to + k * lanes);
  }
  void store(float *to) const
  {
    for (std::size_t k = 0; k < parts; ++k)
      hn::Store(
          hn::DemoteTo(Narrow(), part[k].lanes), Narrow(), to + k * lanes);
  }

  friend RowPack operator+(const RowPack &a, const RowPack &b)
  {
    return apply(a, b, [](P x, P y) { return x + y; });
  }
  friend RowPack operator-(const RowPack &a, const RowPack &b)
  {
    return apply(a, b, [](P x, P y) { return x - y; });
  }
  friend RowPack operator*(const RowPack &a, const RowPack &b)
  {
    return apply(a, b, [](P x, P y) { return x * y; });
  }
  friend RowPack operator/(const RowPack &a, const RowPack &b)
  {
    return apply(a, b, [](P x, P y) { return x / y; });
  }
  friend RowPack
  multiply_add(const RowPack &a, const RowPack &b, const RowPack &c)
  {
    RowPack row;
    for (std::size_t k = 0; k < parts; ++k)
      row.part[k] = multiply_add(a.part[k], b.part[k], c.part[k]);
    return row;
  }
  friend RowPack larger(const RowPack &a, const RowPack &b)
  {
    return apply(a, b, [](P x, P y) { return max(x, y); });
  }
  /// The size of a with the sign of b.
  friend RowPack with_sign_of(const RowPack &a, const RowPack &b)
  {
    return apply(
        a, b, [](P x, P y) { return P(hn::CopySign(x.lanes, y.lanes)); });
  }
  friend RowPack root(const RowPack &a)
  {
    return apply(a, a, [](P x, P) { return sqrt(x); });
  }

  /// In every number the sum of its half.
  friend RowPack half_sums(const RowPack &a)
  {
    RowPack sum;
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX2
    for (std::size_t k = 0; k < parts; ++k) {
      const auto pairs =
          hn::Add(a.part[k].lanes, hn::Shuffle01(a.part[k].lanes));
      sum.part[k] = P(hn::Add(pairs, hn::SwapAdjacentBlocks(pairs)));
    }
#else
    alignas(64) double n[8];
    a.store(n);
    for (int h = 0; h < 8; h += 4)
      n[h] = n[h + 1] = n[h + 2] = n[h + 3] =
          (n[h] + n[h + 1]) + (n[h + 2] + n[h + 3]);
    sum = load(n);
#endif
    return sum;
  }

private:
  template <class Operation>
  static RowPack apply(const RowPack &a, const RowPack &b, Operation &&of)
  {
    RowPack row;
    for (std::size_t k = 0; k < parts; ++k)
      row.part[k] = of(a.part[k], b.part[k]);
    return row;
  }
};

/// A 3 x 3 matrix that acts on the first three numbers of a row. The others
/// become zero.
class RowMatrix
{
public:
  explicit RowMatrix(const double (&matrix)[9])
  {
    for (int c = 0; c < 3; ++c) {
      alignas(64) double column[8] = {
          matrix[c], matrix[3 + c], matrix[6 + c], 0, 0, 0, 0, 0};
      column_[c] = RowPack::load(column);
    }
  }
  RowPack times(const RowPack &row) const
  {
    alignas(64) double n[8];
    row.store(n);
    return multiply_add(column_[1], RowPack(n[1]), column_[0] * RowPack(n[0])) +
           column_[2] * RowPack(n[2]);
  }

private:
  RowPack column_[3];
};
} // namespace tamp::dem::HWY_NAMESPACE

#endif
