// SPDX-License-Identifier: BSD-3-Clause
#include <fem/tool_surface.h>

#include <cmath>
#include <utility>

namespace tamp::fem
{
namespace
{
using Vector = dealii::Tensor<1, 3>;

/// Adds factor * direction (x) direction.
void add_square(double factor,
                const Vector &direction,
                dealii::SymmetricTensor<2, 3> &sum)
{
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = i; j < 3; ++j)
      sum[i][j] += factor * direction[i] * direction[j];
}

/// A profile's normal and its gradient on the axis: what is not along the axis
/// cancels around it.
SurfacePoint on_axis(const ProfilePoint &point)
{
  SurfacePoint result;
  result.distance = point.distance;
  if (point.normal[1] != 0)
    result.normal[2] = std::copysign(1., point.normal[1]);
  else
    result.normal[0] = point.normal[0];
  return result;
}
} // namespace

ToolSurface::ToolSurface(Kind kind, Profile profile, double rim)
    : kind_(kind), profile_(std::move(profile)), rim_(rim)
{
}

ToolSurface ToolSurface::revolved(Profile profile)
{
  return {Kind::revolved,
          std::move(profile),
          std::numeric_limits<double>::infinity()};
}

ToolSurface ToolSurface::extruded(Profile profile, double rim)
{
  return {Kind::extruded, std::move(profile), rim};
}

Profile::Point ToolSurface::flat(const Vector &position) const
{
  return kind_ == Kind::revolved
             ? Profile::Point(
                   {std::hypot(position[0], position[1]), position[2]})
             : Profile::Point({position[0], position[1]});
}

SurfacePoint ToolSurface::spatial(const Vector &position,
                                  const ProfilePoint &point) const
{
  return kind_ == Kind::revolved ? revolved_point(position, point)
                                 : extruded_point(position, point);
}

SurfacePoint ToolSurface::nearest(const Vector &position) const
{
  return spatial(position, profile_.nearest(flat(position)));
}

SurfacePoint ToolSurface::nearest(const Vector &position, unsigned face) const
{
  const ProfilePoint point = profile_.nearest(flat(position), face);
  if (std::isinf(point.distance))
    return {point.distance, {}, {}};
  return spatial(position, point);
}

SurfacePoint ToolSurface::revolved_point(const Vector &position,
                                         const ProfilePoint &point) const
{
  const double r = std::hypot(position[0], position[1]);
  const double radial = point.normal[0], axial = point.normal[1];
  // Near the axis of a smooth face both numbers are small, and radial / r is
  // the curvature but for rounding.
  constexpr double small = 1e-6;
  const bool smooth =
      std::abs(radial) < small && std::abs(r * point.curvature) < small;
  if (!(r > 0) && !smooth)
    return on_axis(point);
  const double cosine = r > 0 ? position[0] / r : 1;
  const double sine = r > 0 ? position[1] / r : 0;
  SurfacePoint result;
  result.distance = point.distance;
  result.normal = Vector({radial * cosine, radial * sine, axial});
  add_square(point.curvature,
             Vector({axial * cosine, axial * sine, -radial}),
             result.normal_gradient);
  add_square(smooth ? point.curvature : radial / r,
             Vector({-sine, cosine, 0}),
             result.normal_gradient);
  return result;
}

SurfacePoint ToolSurface::extruded_point(const Vector &position,
                                         const ProfilePoint &point) const
{
  const double above = position[2] - rim_;
  const Vector side({point.normal[0], point.normal[1], 0});
  const Vector up({0, 0, 1});
  const Vector tangent({-point.normal[1], point.normal[0], 0});
  SurfacePoint result;
  if (above > 0 && point.distance > 0) { // over the powder: the rim's edge
    result.distance = std::hypot(point.distance, above);
    const double sine = point.distance / result.distance;
    const double cosine = above / result.distance;
    result.normal = sine * side + cosine * up;
    add_square(
        1 / result.distance, cosine * side - sine * up, result.normal_gradient);
    add_square(sine * point.curvature, tangent, result.normal_gradient);
  } else if (above > point.distance) { // the rim is closer than the wall
    result.distance = above;
    result.normal = up;
  } else {
    result.distance = point.distance;
    result.normal = side;
    add_square(point.curvature, tangent, result.normal_gradient);
  }
  return result;
}
} // namespace tamp::fem
