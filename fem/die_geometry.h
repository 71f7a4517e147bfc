// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_die_geometry_h
#define fem_die_geometry_h

#include <fem/mesh.h>

#include <string>

namespace tamp::fem
{
/// The face of a punch, a surface of revolution about the pressing axis.
struct PunchFace {
  enum class Kind {
    flat,
    convex,  ///< a dome of `radius` that stands out: makes a hollow tablet
    concave, ///< a cup of `radius`: makes a domed tablet
    chamfer, ///< flat, with a rim of `width` that stands out at 45 degrees
    bevel    ///< flat, with a rim of `width` that stands out at `angle`
  };
  Kind kind = Kind::flat;
  double radius = 0; ///< of curvature [m]
  double width = 0;  ///< of the rim, along the radius [m]
  double angle = 0;  ///< of the rim against the face [rad]

  /// How far the face stands out towards the powder at distance r from the
  /// axis, measured from its edge at `edge` [m]; negative: recessed. Beyond
  /// its edge it goes straight on.
  double height(double r, double edge) const;
};

enum class DieShape { cylinder, ring, square, file };

/// The powder in the filled die and the tools around it. Lengths in m.
struct DieGeometry {
  DieShape shape = DieShape::cylinder;
  Section section = Section::axisymmetric;
  double radius = 6e-3;        ///< of the bore: cylinder, ring
  double core_radius = 2e-3;   ///< of the core rod: ring
  double side = 12e-3;         ///< of the square, wall to wall
  double corner_radius = 1e-3; ///< of the square's vertical edges; may be zero
  double fill_height = 7e-3;   ///< from edge to edge of the punches
  PunchFace upper_face, lower_face; ///< square: flat
  /// The bore widens towards its rim at this angle against the pressing axis
  /// [rad], over this length; zero: straight.
  double exit_taper_angle = 0, exit_taper_length = 0;
  unsigned radial_elements = 4; ///< along the radius, half the side
  unsigned axial_elements = 7;
  /// A mesh of the powder (gmsh .msh), shape `file`.
  std::string mesh_file;

  /// Throws std::invalid_argument naming the first value that is not possible.
  void check() const;
};
} // namespace tamp::fem

#endif
