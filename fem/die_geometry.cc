// SPDX-License-Identifier: BSD-3-Clause
#include <fem/die_geometry.h>
#include <fem/require.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tamp::fem
{
namespace
{
/// Height of a dome of this radius above its edge; beyond the edge it goes
/// straight on.
double dome_height(double r, double edge, double radius)
{
  const double at_edge = std::sqrt(radius * radius - edge * edge);
  if (r > edge)
    return -(r - edge) * edge / at_edge;
  return (edge - r) * (edge + r) /
         (at_edge + std::sqrt(radius * radius - r * r));
}

bool is_length(double value)
{
  return value > 0 && std::isfinite(value);
}

void require_length(const std::string &name, double value)
{
  require(is_length(value), name, value, "> 0 m");
}

std::string metres(double value)
{
  std::ostringstream text;
  text << value << " m";
  return text.str();
}

/// @param inner, outer  radii between which the face meets powder [m].
/// @param half_height  of the fill [m].
void check_face(const PunchFace &face,
                const std::string &name,
                double inner,
                double outer,
                double half_height)
{
  using Kind = PunchFace::Kind;
  if (face.kind == Kind::flat)
    return;
  if (face.kind == Kind::convex || face.kind == Kind::concave) {
    require(face.radius > outer && std::isfinite(face.radius),
            name + ": radius",
            face.radius,
            "more than the radius of the bore, " + metres(outer));
  } else {
    require(face.width > 0 && face.width < outer - inner,
            name + ": width of the rim",
            face.width,
            "> 0 m and less than the face's, " + metres(outer - inner));
  }
  if (face.kind == Kind::bevel)
    require(face.angle > 0 && face.angle < std::numbers::pi / 2,
            name + ": angle of the rim",
            face.angle,
            "more than 0 and less than pi/2 (90 degrees)");
  const double depth = std::abs(face.height(inner, outer));
  require(depth < half_height,
          name + ": depth",
          depth,
          "less than half the fill height, " + metres(half_height));
}

void check_taper(const DieGeometry &die)
{
  const double angle = die.exit_taper_angle, length = die.exit_taper_length;
  require(angle >= 0 && angle < std::numbers::pi / 4,
          "exit taper angle",
          angle,
          "at least 0 and less than pi/4 (45 degrees)");
  require(length >= 0, "exit taper length", length, ">= 0 m");
  if (!(angle > 0))
    return;
  require(die.shape == DieShape::cylinder || die.shape == DieShape::ring,
          "exit taper angle",
          angle,
          "0: only the round bore of a cylinder or ring can have a taper");
  require(length > 0 && length < die.fill_height,
          "exit taper length",
          length,
          "> 0 m and less than the fill height, " + metres(die.fill_height));
}

void check_round(const DieGeometry &die)
{
  require_length("radius", die.radius);
  const bool ring = die.shape == DieShape::ring;
  if (ring) {
    require_length("core radius", die.core_radius);
    require(die.core_radius < die.radius,
            "core radius",
            die.core_radius,
            "less than the radius, " + metres(die.radius));
  }
  const double inner = ring ? die.core_radius : 0;
  const double half_height = die.fill_height / 2;
  check_face(die.upper_face, "upper punch", inner, die.radius, half_height);
  check_face(die.lower_face, "lower punch", inner, die.radius, half_height);
}

/// Shapes whose faces are not of revolution, or read from a file.
void require_flat(const DieGeometry &die, const std::string &reason)
{
  const auto check = [&](const PunchFace &face, const std::string &name) {
    require(face.kind == PunchFace::Kind::flat,
            name + ": kind of face",
            static_cast<int>(face.kind),
            "flat (0): " + reason);
  };
  check(die.upper_face, "upper punch");
  check(die.lower_face, "lower punch");
}

void check_square(const DieGeometry &die)
{
  require_length("side", die.side);
  require(die.corner_radius >= 0 && die.corner_radius <= die.side / 2,
          "corner radius",
          die.corner_radius,
          "at least 0 and at most half the side, " + metres(die.side / 2));
  require(die.section != Section::axisymmetric,
          "section",
          static_cast<int>(die.section),
          "a quarter (1) or full (2): a square is not axisymmetric");
  require_flat(die, "a square has flat punches");
}
} // namespace

double PunchFace::height(double r, double edge) const
{
  switch (kind) {
  case Kind::flat:
    return 0;
  case Kind::convex:
    return dome_height(r, edge, radius);
  case Kind::concave:
    return -dome_height(r, edge, radius);
  case Kind::chamfer:
    return -std::min(edge - r, width);
  case Kind::bevel:
    return -std::min(edge - r, width) * std::tan(angle);
  }
  return 0;
}

void DieGeometry::check() const
{
  if (shape == DieShape::file || !mesh_file.empty()) {
    require(!mesh_file.empty(), "mesh file", "empty", "the name of a mesh");
    require_flat(*this, "a mesh from a file has its own faces");
    check_taper(*this);
    return;
  }
  require_length("fill height", fill_height);
  if (shape == DieShape::square)
    check_square(*this);
  else
    check_round(*this);
  check_taper(*this);
  require(radial_elements > 0, "radial elements", radial_elements, "> 0");
  require(axial_elements > 0, "axial elements", axial_elements, "> 0");
}
} // namespace tamp::fem
