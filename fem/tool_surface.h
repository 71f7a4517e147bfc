// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_tool_surface_h
#define fem_tool_surface_h

#include <fem/die_geometry.h>
#include <fem/profile.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <limits>
#include <optional>

namespace tamp::fem
{
/// What a tool's surface says at a place.
struct SurfacePoint {
  double distance = 0;         ///< to the surface [m]; negative inside the tool
  dealii::Tensor<1, 3> normal; ///< unit, from the tool into the powder
  dealii::SymmetricTensor<2, 3> normal_gradient; ///< d normal / d x [1/m]
};

/// The surface of a rigid tool, at its place at the start.
class ToolSurface
{
public:
  /// A profile in (r, z), turned about the z axis. It is looked at from r >= 0
  /// only, but goes on beyond the axis: a face that crosses the axis must be
  /// drawn on both sides. On the axis the normal is along z if the profile's
  /// has a part along z, else along x.
  static ToolSurface revolved(Profile profile);
  /// A profile in (x, y), drawn along z from below up to a flat rim at z =
  /// `rim` [m]. Above the rim the distance is that to the rim: positive.
  static ToolSurface
  extruded(Profile profile,
           double rim = std::numeric_limits<double>::infinity());

  SurfacePoint nearest(const dealii::Tensor<1, 3> &position) const;

  /// Faces between sharp hollow edges, and one of them alone: see
  /// Profile::nearest().
  unsigned faces() const { return profile_.faces(); }
  SurfacePoint nearest(const dealii::Tensor<1, 3> &position,
                       unsigned face) const;

private:
  enum class Kind { revolved, extruded };
  ToolSurface(Kind kind, Profile profile, double rim);

  /// In the plane of the profile.
  Profile::Point flat(const dealii::Tensor<1, 3> &position) const;
  /// What the profile's answer means in space.
  SurfacePoint spatial(const dealii::Tensor<1, 3> &position,
                       const ProfilePoint &point) const;
  SurfacePoint revolved_point(const dealii::Tensor<1, 3> &position,
                              const ProfilePoint &point) const;
  SurfacePoint extruded_point(const dealii::Tensor<1, 3> &position,
                              const ProfilePoint &point) const;

  Kind kind_;
  Profile profile_;
  double rim_;
};

/// The surfaces of the tools; none for a tool that is not there.
using ToolSurfaces = std::array<std::optional<ToolSurface>, number_of_tools>;

/// The tools of a filled die, whose axis is the z axis. The lower punch's edge
/// is at z = 0. The bore ends at a rim at the height of the upper punch's edge;
/// the core rod has no ends. The punches go straight on beyond the bore. A
/// square's wall is the whole square, whatever the section. For shape `file`
/// the tools are read off the mesh, of which nothing else is used: each is a
/// smooth surface through the nodes of its faces, see fem/mesh_tools.h. Throws
/// std::invalid_argument like DieGeometry::check(), std::runtime_error if the
/// mesh's tools have another shape.
ToolSurfaces make_tools(const DieGeometry &geometry, const Mesh &mesh);
} // namespace tamp::fem

#endif
