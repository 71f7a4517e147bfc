// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_turning_h
#define dem_laws_turning_h

#include <dem/laws/lane_math.h>

namespace tamp::dem
{
/// 1 / sqrt(1 - u) for 0 <= u <= 1, which is near 0 but for contacts that
/// turned far.
template <class V>
V stretch_back(const V &u)
{
  if (any(u > V(1e-4))) // series below: within 1e-16
    return V(1.0) / sqrt(max(V(1.0) - u, V(1e-12)));
  return V(1.0) + u * (V(0.5) + u * (V(3.0 / 8) + u * V(5.0 / 16)));
}

/// A force or moment across the normal, turned with its contact: back into the
/// contact plane at its old length, then with the spin of the grains about the
/// normal.
template <class V>
Triple<V> turned(const Triple<V> &old, const Triple<V> &normal, const V &spin)
{
  const V out = dot(old, normal);
  const V u = min(V(1.0), out * out / max(dot(old, old), V(tiny)));
  const Triple<V> kept = stretch_back(u) * (old - out * normal);
  return kept + spin * cross(normal, kept);
}
} // namespace tamp::dem

#endif
