// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_pack_h
#define dem_kernel_pack_h

#include <cstddef>
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

// Everything here is compiled once per instruction set; the name of the set is
// part of every name, so that no two of them are ever mixed.
namespace tamp::dem::HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// As many numbers as a register holds, at most a block of contacts.
template <class T>
class Pack
{
public:
  using Tag = hn::CappedTag<T, 16>;
  using Lanes = hn::Vec<Tag>;
  static constexpr std::size_t size = hn::MaxLanes(Tag());

  struct Mask {
    hn::Mask<Tag> lanes;
    friend Mask operator&(Mask a, Mask b)
    {
      return {hn::And(a.lanes, b.lanes)};
    }
    friend Mask operator|(Mask a, Mask b) { return {hn::Or(a.lanes, b.lanes)}; }
    friend Mask operator!(Mask a) { return {hn::Not(a.lanes)}; }
  };

  Lanes lanes;

  Pack() = default;
  Pack(double value) : lanes(hn::Set(Tag(), T(value))) {}
  explicit Pack(Lanes lanes) : lanes(lanes) {}

  static Pack load(const T *from) { return Pack(hn::Load(Tag(), from)); }
  void store(T *to) const { hn::Store(lanes, Tag(), to); }

  friend Pack operator+(Pack a, Pack b) { return Pack(a.lanes + b.lanes); }
  friend Pack operator-(Pack a, Pack b) { return Pack(a.lanes - b.lanes); }
  friend Pack operator*(Pack a, Pack b) { return Pack(a.lanes * b.lanes); }
  friend Pack operator/(Pack a, Pack b) { return Pack(a.lanes / b.lanes); }
  friend Pack operator-(Pack a) { return Pack(hn::Neg(a.lanes)); }
  Pack &operator+=(Pack b) { return *this = *this + b; }
  Pack &operator-=(Pack b) { return *this = *this - b; }
  Pack &operator*=(Pack b) { return *this = *this * b; }

  friend Mask operator<(Pack a, Pack b) { return {a.lanes < b.lanes}; }
  friend Mask operator>(Pack a, Pack b) { return {a.lanes > b.lanes}; }
  friend Mask operator<=(Pack a, Pack b) { return {a.lanes <= b.lanes}; }
  friend Mask operator>=(Pack a, Pack b) { return {a.lanes >= b.lanes}; }

  friend Pack max(Pack a, Pack b) { return Pack(hn::Max(a.lanes, b.lanes)); }
  friend Pack min(Pack a, Pack b) { return Pack(hn::Min(a.lanes, b.lanes)); }
  friend Pack sqrt(Pack a) { return Pack(hn::Sqrt(a.lanes)); }
  friend Pack abs(Pack a) { return Pack(hn::Abs(a.lanes)); }
  friend Pack arc_cosine(Pack a) { return Pack(hn::Acos(Tag(), a.lanes)); }
  friend Pack multiply_add(Pack a, Pack b, Pack c)
  {
    return Pack(hn::MulAdd(a.lanes, b.lanes, c.lanes));
  }
  friend Pack subtract_product(Pack a, Pack b, Pack c)
  {
    return Pack(hn::NegMulAdd(b.lanes, c.lanes, a.lanes));
  }
  friend Pack select(Mask mask, Pack yes, Pack no)
  {
    return Pack(hn::IfThenElse(mask.lanes, yes.lanes, no.lanes));
  }
  friend bool any(Mask mask) { return !hn::AllFalse(Tag(), mask.lanes); }
  friend T sum(Pack a) { return hn::GetLane(hn::SumOfLanes(Tag(), a.lanes)); }
  friend T largest(Pack a)
  {
    return hn::GetLane(hn::MaxOfLanes(Tag(), a.lanes));
  }
};
} // namespace tamp::dem::HWY_NAMESPACE

#endif
