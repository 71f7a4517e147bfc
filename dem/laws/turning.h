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
  const V near = multiply_add(V(0.5), u, V(1.0)); // within 1e-16 below 1e-8
  const auto far = u > V(1e-8);
  if (any(far))
    return select(far, V(1.0) / sqrt(max(V(1.0) - u, V(1e-12))), near);
  return near;
}

/// A force or moment across the normal, turned with its contact: back into the
/// contact plane at its old length, then with the spin of the grains about the
/// normal; times `scale`.
template <class V>
Triple<V> turned(const Triple<V> &old,
                 const Triple<V> &normal,
                 const V &spin,
                 const V &scale = V(1.0))
{
  const V out = dot(old, normal);
  const V u = min(V(1.0), out * out / max(dot(old, old), V(tiny)));
  const Triple<V> flat = subtract_product(old, out, normal);
  return (scale * stretch_back(u)) *
         multiply_add(spin, cross(normal, flat), flat);
}
} // namespace tamp::dem

#endif
