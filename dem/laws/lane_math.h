// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_lane_math_h
#define dem_laws_lane_math_h

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace tamp::dem
{
// Contact laws are written once for V = double, as tests and measures use
// them, and for packs of lanes, as the sweep does. They may use + - * /, the
// comparisons, which give a mask, sqrt, and what follows here; packs bring
// their own overloads. Branches are written with select() and any().
using std::abs;
using std::max;
using std::min;
using std::sqrt;

/// A positive number that keeps a division finite, above zero in any
/// precision.
constexpr double tiny = 1e-37;

/// `yes` where the mask holds, `no` elsewhere. Both are always evaluated.
template <class V>
requires std::is_arithmetic_v<V> V select(bool mask, V yes, V no)
{
  return mask ? yes : no;
}

/// Whether the mask holds in any lane.
inline bool any(bool mask)
{
  return mask;
}

/// arccos x for -1 <= x <= 1 [rad].
template <class V>
requires std::is_arithmetic_v<V> V arc_cosine(V x)
{
  return std::acos(x);
}

/// x^(1/3) for 0 <= x <= 1, exactly 0 at 0; absolute error below 1e-14 in
/// double. Starts at x^(21/64), made of square roots, and takes four steps of
/// Halley, each of which cubes the error.
template <class V>
V cube_root(const V &x)
{
  const V fourth = sqrt(sqrt(x)), sixteenth = sqrt(sqrt(fourth));
  V y = fourth * sixteenth * sqrt(sqrt(sixteenth));
  for (int step = 0; step < 4; ++step) {
    const V cube = y * y * y;
    y = y * ((cube + V(2.0) * x) / max(V(2.0) * cube + x, V(tiny)));
  }
  return y;
}

/// e^x for -4.4 <= x <= 0, to 1e-13 of its value: a polynomial of degree 9 in
/// x / 32, squared five times.
template <class V>
V negative_exponential(const V &x)
{
  const V part = x * V(1.0 / 32);
  V power = V(1.0);
  for (double order = 9; order > 0; order -= 1)
    power = V(1.0) + power * part * V(1 / order);
  for (int doubling = 0; doubling < 5; ++doubling)
    power = power * power;
  return power;
}

/// A vector of three packs.
template <class V>
struct Triple {
  V x, y, z;

  friend Triple operator+(const Triple &a, const Triple &b)
  {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Triple operator-(const Triple &a, const Triple &b)
  {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Triple operator*(const V &s, const Triple &a)
  {
    return {s * a.x, s * a.y, s * a.z};
  }
};

template <class V>
V dot(const Triple<V> &a, const Triple<V> &b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class V>
Triple<V> cross(const Triple<V> &a, const Triple<V> &b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The part of `a` across the unit vector `n`.
template <class V>
Triple<V> across(const Triple<V> &a, const Triple<V> &n)
{
  return a - dot(a, n) * n;
}
} // namespace tamp::dem

#endif
