// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_laws_lane_pack_h
#define tests_dem_laws_lane_pack_h

#include <dem/laws/lane_math.h>

#include <array>

namespace tamp::dem
{
/// A pack of four lanes with no more than laws may use: + - * /, the
/// comparison >, sqrt, min, max, select and arc_cosine.
template <class T>
struct LanePack {
  static constexpr int lanes = 4;
  using Mask = std::array<bool, lanes>;
  std::array<T, lanes> lane;

  LanePack() = default;
  explicit LanePack(double x) { lane.fill(T(x)); }

  template <class Make>
  static LanePack each(const Make &make)
  {
    LanePack made;
    for (int k = 0; k < lanes; ++k)
      made.lane[k] = make(k);
    return made;
  }
  friend LanePack operator+(const LanePack &a, const LanePack &b)
  {
    return each([&](int k) { return a.lane[k] + b.lane[k]; });
  }
  friend LanePack operator-(const LanePack &a, const LanePack &b)
  {
    return each([&](int k) { return a.lane[k] - b.lane[k]; });
  }
  friend LanePack operator*(const LanePack &a, const LanePack &b)
  {
    return each([&](int k) { return a.lane[k] * b.lane[k]; });
  }
  friend LanePack operator/(const LanePack &a, const LanePack &b)
  {
    return each([&](int k) { return a.lane[k] / b.lane[k]; });
  }
  friend Mask operator>(const LanePack &a, const LanePack &b)
  {
    Mask mask;
    for (int k = 0; k < lanes; ++k)
      mask[k] = a.lane[k] > b.lane[k];
    return mask;
  }
  friend LanePack max(const LanePack &a, const LanePack &b)
  {
    return each([&](int k) { return std::max(a.lane[k], b.lane[k]); });
  }
  friend LanePack min(const LanePack &a, const LanePack &b)
  {
    return each([&](int k) { return std::min(a.lane[k], b.lane[k]); });
  }
  friend LanePack sqrt(const LanePack &a)
  {
    return each([&](int k) { return std::sqrt(a.lane[k]); });
  }
  friend LanePack arc_cosine(const LanePack &a)
  {
    return each([&](int k) { return std::acos(a.lane[k]); });
  }
  friend LanePack
  select(const Mask &mask, const LanePack &yes, const LanePack &no)
  {
    return each([&](int k) { return mask[k] ? yes.lane[k] : no.lane[k]; });
  }
};
} // namespace tamp::dem

#endif
