// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_tool_surface_h
#define fem_tool_surface_h

#include <fem/die_geometry.h>
#include <fem/profile.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
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
  /// A profile in (r, z), turned about the z axis.
  static ToolSurface revolved(Profile profile);
  /// A profile in (x, y), drawn along z.
  static ToolSurface extruded(Profile profile);

  SurfacePoint nearest(const dealii::Tensor<1, 3> &position) const;
};

/// The surfaces of the tools; none for a tool that is not there.
using ToolSurfaces = std::array<std::optional<ToolSurface>, number_of_tools>;

/// The tools of a filled die. The bore ends at a rim at the height of the upper
/// punch's edge; the core rod reaches as high as the powder goes. For shape
/// `file` the tools are read off the mesh: each is a profile through the nodes
/// of its faces.
ToolSurfaces make_tools(const DieGeometry &geometry, const Mesh &mesh);
} // namespace tamp::fem

#endif
