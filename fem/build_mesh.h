// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_build_mesh_h
#define fem_build_mesh_h

#include <fem/die_geometry.h>
#include <fem/mesh.h>

namespace tamp::fem
{
/// The mesh of the powder in a die of a built-in shape: a grid across the
/// pressing axis, drawn along it in slices that are numbered from below and
/// stretched between the faces of the punches. A column stands at the inner
/// edge of each punch's rim if there are elements enough along the radius of
/// an axisymmetric mesh or a ring. At the start the powder fills the straight
/// bore only, not an exit taper.
///
/// Held are the axis (axisymmetric), the planes of symmetry (quarter), or the
/// nodes on the pressing axis in x and y (full), which the symmetry of these
/// shapes makes exact. A full mesh may turn about its axis, and a full ring,
/// which has no nodes there, also shift: only the tools hold it.
///
/// Throws std::invalid_argument if a value is not possible (DieGeometry::check)
/// or the shape is a file.
Mesh build_mesh(const DieGeometry &geometry);
} // namespace tamp::fem

#endif
