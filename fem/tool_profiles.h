// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_tool_profiles_h
#define fem_tool_profiles_h

#include <fem/die_geometry.h>
#include <fem/profile.h>

namespace tamp::fem
{
/// The face of a punch in (r, z), drawn on both sides of the axis. Beyond its
/// edge it goes straight on. Lengths in m.
/// @param edge    distance of its edge from the axis.
/// @param z       height of its edge.
/// @param upward  a lower punch, whose powder is above.
Profile
punch_profile(const PunchFace &face, double edge, double z, bool upward);

/// A bore in (r, z) that ends at a rim at height `rim`; over the last `length`
/// it widens at `angle` [rad] against the axis. Lengths in m.
Profile
bore_profile(double radius, double rim, double angle = 0, double length = 0);

/// A core rod in (r, z) without ends.
/// @param radius  [m].
Profile rod_profile(double radius);

/// The outline in (x, y) of a rectangular bore about the z axis with rounded
/// corners.
/// @param half_x, half_y  half its sides [m].
/// @param corner_radius   zero: sharp corners [m].
Profile
rectangle_profile(double half_x, double half_y, double corner_radius = 0);
} // namespace tamp::fem

#endif
