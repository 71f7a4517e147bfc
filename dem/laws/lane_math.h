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

/// a b + c, rounded once where the machine can.
template <class V>
requires std::is_arithmetic_v<V> V multiply_add(V a, V b, V c)
{
  return a * b + c;
}

/// a - b c, likewise.
template <class V>
requires std::is_arithmetic_v<V> V subtract_product(V a, V b, V c)
{
  return a - b * c;
}

/// arccos x for -1 <= x <= 1 [rad].
template <class V>
requires std::is_arithmetic_v<V> V arc_cosine(V x)
{
  return std::acos(x);
}

template <class V>
struct Root {
  V root, inverse;
};

/// The root of x >= 0 and its inverse, at most 3e18. Both are on their way at
/// once, which is sooner there than one after the other.
template <class V>
Root<V> root_of(const V &x)
{
  const V root = sqrt(x);
  return {root, root * (V(1.0) / max(x, V(tiny)))};
}

template <class V>
struct Inverses {
  V first, second;
};

/// 1 / a and 1 / b for a, b >= 0 by one division; at most 1e18.
template <class V>
Inverses<V> inverses(const V &a, const V &b)
{
  constexpr double least = 1e-18; // its square is above zero in any precision
  const V p = max(a, V(least)), q = max(b, V(least));
  const V inverse = V(1.0) / (p * q);
  return {inverse * q, inverse * p};
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

/// s a + c and c - s a.
template <class V>
Triple<V> multiply_add(const V &s, const Triple<V> &a, const Triple<V> &c)
{
  return {multiply_add(s, a.x, c.x),
          multiply_add(s, a.y, c.y),
          multiply_add(s, a.z, c.z)};
}
template <class V>
Triple<V> subtract_product(const Triple<V> &c, const V &s, const Triple<V> &a)
{
  return {subtract_product(c.x, s, a.x),
          subtract_product(c.y, s, a.y),
          subtract_product(c.z, s, a.z)};
}

template <class V>
V dot(const Triple<V> &a, const Triple<V> &b)
{
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, a.z * b.z));
}

template <class V>
Triple<V> cross(const Triple<V> &a, const Triple<V> &b)
{
  return {subtract_product(a.y * b.z, a.z, b.y),
          subtract_product(a.z * b.x, a.x, b.z),
          subtract_product(a.x * b.y, a.y, b.x)};
}

/// The part of `a` across the unit vector `n`.
template <class V>
Triple<V> across(const Triple<V> &a, const Triple<V> &n)
{
  return subtract_product(a, dot(a, n), n);
}
} // namespace tamp::dem

#endif
