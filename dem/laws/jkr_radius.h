// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_jkr_radius_h
#define dem_laws_jkr_radius_h

#include <dem/laws/lane_math.h>

namespace tamp::dem
{
/// x^(1/3) for x > 0 from two square roots and two divisions: to 1e-9 for
/// x in [1e-3, 1e3], to 3e-4 in [1e-6, 1e6].
template <class V>
V quick_cube_root(const V &x)
{
  // With z = x^(1/4) the root is z z^(1/3): Pade's (1 + 2 z)/(2 + z) for the
  // second factor and a step of Halley's in one fraction, then another step.
  const V z = sqrt(sqrt(x));
  const V above = V(1.0) + V(2.0) * z, below = V(2.0) + z;
  const V above3 = above * above * above, below3 = below * below * below;
  const V y = z * above * (above3 + V(2.0) * z * below3) /
              (below * (V(2.0) * above3 + z * below3));
  const V y3 = y * y * y;
  return y * (y3 + V(2.0) * x) / (V(2.0) * y3 + x);
}

/// The larger root t of t^4 - pull t = push, for a pull of 3.9 to 4.1; t is
/// near 1 at the smallest push that has a root, -3. A smaller push gives a
/// finite number of no meaning.
template <class V>
V jkr_root(const V &pull, const V &push)
{
  // Ferrari: with y^3 + 4 push y = pull^2, t solves t^2 + y/2 = sqrt(y) t +
  // pull / (2 sqrt(y)). The cubic has one positive root, simple even where
  // the two of the quartic meet; Newton on the quartic would crawl there.
  // Its start is a hyperbola for 1/y, to 4 per cent; four steps leave 4e-16.
  const V d = max(push, V(-4.0));
  const V shifted = V(0.125) * d - V(0.082);
  V y = V(1.0) / (V(0.125) * d + V(0.082) + sqrt(shifted * shifted + V(0.09)));
  const V pull2 = pull * pull;
  for (int step = 0; step < 4; ++step) {
    const V y2 = y * y;
    y = (V(2.0) * y * y2 + pull2) / (V(3.0) * y2 + V(4.0) * d);
  }
  const V root = sqrt(y);
  return V(0.5) * (root + sqrt(max(V(0.0), V(2.0) * pull / root - y)));
}
} // namespace tamp::dem

#endif
