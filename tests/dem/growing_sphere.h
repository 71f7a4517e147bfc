// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_dem_growing_sphere_h
#define tests_dem_growing_sphere_h

#include <dem/laws/mdr.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tamp::dem
{
inline constexpr double pi = std::numbers::pi;

// The grain of Zunker & Kamrin's examples.
inline const Mdr soft(1e9, 0.3, 50e6);
inline constexpr double R_o = 0.5;

inline double ball(double R)
{
  return 4.0 / 3 * pi * R * R * R;
}
inline double cap(double R, double h)
{
  return pi / 3 * (R - h) * (R - h) * (2 * R + h);
}

/// The published rate of R, integrated by small Euler steps.
inline double integrated_rate(double h_end, int n)
{
  const double kappa = soft.bulk_modulus();
  constexpr int steps = 200000;
  const double h_Y = R_o - soft.flat().yield_ratio() * R_o;
  double R = R_o, V_o = ball(R_o);
  const auto strain = [&](double h) {
    return -soft.flat().peak(R - h, R).force * h / (3 * kappa * V_o);
  };
  double before = strain(h_Y);
  for (int i = 1; i <= steps; ++i) {
    const double change = (h_Y - h_end) / steps, h = h_Y - i * change;
    const double d_o = R_o - h; // delta_o
    const double now = strain(h);
    const double above =
        -n * V_o * (now - before) -
        pi * n * change * (2 * d_o * R_o - d_o * d_o + R * R - R_o * R_o);
    const double below = 2 * pi * R * n * (d_o + R - R_o) - 4 * pi * R * R;
    before = now;
    R += std::max(0.0, above / below);
  }
  return R;
}

} // namespace tamp::dem

#endif
