// SPDX-License-Identifier: BSD-3-Clause
#include <fem/tool_profiles.h>

#include <cmath>
#include <vector>

namespace tamp::fem
{
namespace
{
using Point = Profile::Point;

struct Outline {
  std::vector<Point> corners;
  std::vector<double> radii;
};

/// A face whose powder is above and whose edge is at z = 0.
Outline outline(const PunchFace &face, double edge)
{
  using Kind = PunchFace::Kind;
  const Point left({-edge, 0}), right({edge, 0});
  if (face.kind == Kind::flat)
    return {{left, right}, {}};
  if (face.kind == Kind::chamfer || face.kind == Kind::bevel) {
    const double inner = edge - face.width;
    const double height = face.height(0, edge);
    return {{left, Point({-inner, height}), Point({inner, height}), right}, {}};
  }
  // The tangents of the dome at its edge and on its top meet at two corners;
  // one arc from edge to edge would have its corner far off if it were steep.
  const double at_edge = std::sqrt((face.radius - edge) * (face.radius + edge));
  const double corner = face.radius * edge / (face.radius + at_edge);
  const double height = face.height(0, edge);
  return {{left, Point({-corner, height}), Point({corner, height}), right},
          {face.radius, face.radius}};
}
} // namespace

Profile punch_profile(const PunchFace &face, double edge, double z, bool upward)
{
  Outline drawn = outline(face, edge);
  // Half a turn of an upper punch gives a lower one.
  for (Point &corner : drawn.corners)
    corner = upward ? Point({corner[0], z + corner[1]})
                    : Point({-corner[0], z - corner[1]});
  return Profile(drawn.corners, drawn.radii);
}

Profile bore_profile(double radius, double rim, double angle, double length)
{
  if (!(angle > 0))
    length = 0;
  const double outer = radius + length * std::tan(angle);
  std::vector<Point> corners{Point({radius, rim - length - radius}),
                             Point({radius, rim - length})};
  if (length > 0)
    corners.push_back(Point({outer, rim}));
  corners.push_back(Point({outer + radius, rim}));
  return Profile(corners);
}

Profile rod_profile(double radius)
{
  return Profile({Point({radius, radius}), Point({radius, 0})});
}

Profile rectangle_profile(double half_x, double half_y, double corner_radius)
{
  return Profile({Point({half_x, half_y}),
                  Point({-half_x, half_y}),
                  Point({-half_x, -half_y}),
                  Point({half_x, -half_y}),
                  Point({half_x, half_y})},
                 std::vector<double>(4, corner_radius));
}
} // namespace tamp::fem
