// SPDX-License-Identifier: BSD-3-Clause
#include <fem/tool_surface.h>

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Kind = PunchFace::Kind;
using Vector = dealii::Tensor<1, 3>;

constexpr double rounding = 1e-17; // of lengths of some mm

std::vector<PunchFace> faces()
{
  return {{},
          {Kind::convex, 12e-3, 0, 0},
          {Kind::concave, 9e-3, 0, 0},
          {Kind::concave, 6.9e-3, 0, 0},
          {Kind::chamfer, 0, 1e-3, 0},
          {Kind::bevel, 0, 2e-3, 0.3}};
}

Vector place(double r, double angle, double z)
{
  return Vector({r * std::cos(angle), r * std::sin(angle), z});
}

SurfacePoint
seen(const ToolSurfaces &tools, Tool tool, double x, double y, double z)
{
  return tools[tool]->nearest(Vector({x, y, z}));
}
} // namespace

TEST(DieTools, PunchesAreWhereTheirFacesAre)
{
  for (const PunchFace &face : faces()) {
    DieGeometry die;
    die.upper_face = die.lower_face = face;
    const ToolSurfaces tools = make_tools(die, {});
    const double edge = die.radius;
    // To the edge and beyond it.
    for (const double r :
         {0., 1e-9, 1e-3, 2.5e-3, 4.5e-3, 5.9e-3, 6e-3, 6.1e-3})
      for (const double angle : {0., 1., 4.}) {
        const double height = face.height(r, edge);
        const double top = die.fill_height - height;
        const auto &upper = *tools[upper_punch], &lower = *tools[lower_punch];
        EXPECT_NEAR(upper.nearest(place(r, angle, top)).distance, 0, rounding);
        EXPECT_NEAR(
            lower.nearest(place(r, angle, height)).distance, 0, rounding);
        // Powder is between them.
        constexpr double step = 1e-6;
        const auto below = upper.nearest(place(r, angle, top - step));
        const auto above = lower.nearest(place(r, angle, height + step));
        EXPECT_GT(below.distance, 0.2 * step);
        EXPECT_GT(above.distance, 0.2 * step);
        EXPECT_LT(below.normal[2], 0);
        EXPECT_GT(above.normal[2], 0);
        EXPECT_LT(upper.nearest(place(r, angle, top + step)).distance, 0);
        EXPECT_LT(lower.nearest(place(r, angle, height - step)).distance, 0);
      }
  }
}

TEST(DieTools, TheBoreEndsAtItsRim)
{
  const DieGeometry die;
  const ToolSurfaces tools = make_tools(die, {});
  const double rim = die.fill_height, radius = die.radius;
  for (const double z : {-1., 0., 5e-3, 6.9e-3}) {
    const SurfacePoint wall = seen(tools, die_wall, 0, radius - 1e-3, z);
    EXPECT_NEAR(wall.distance, 1e-3, rounding);
    EXPECT_NEAR((wall.normal - Vector({0, -1, 0})).norm(), 0, 1e-15);
    EXPECT_NEAR(
        seen(tools, die_wall, radius + 1e-5, 0, z).distance, -1e-5, rounding);
  }
  // A compact that springs back over the rim is free.
  EXPECT_GT(seen(tools, die_wall, radius + 1e-4, 0, rim + 1e-9).distance, 0);
  EXPECT_FALSE(tools[core_rod]);
}

TEST(DieTools, TheTaperWidensTheBoreTowardsItsRim)
{
  DieGeometry die;
  die.exit_taper_angle = 0.1;
  die.exit_taper_length = 2e-3;
  const ToolSurfaces tools = make_tools(die, {});
  const double slope = std::tan(0.1);
  for (const double below : {1e-4, 1e-3, 1.9e-3}) {
    const double r = die.radius + (2e-3 - below) * slope;
    const double z = die.fill_height - below;
    const SurfacePoint wall = seen(tools, die_wall, r, 0, z);
    EXPECT_NEAR(wall.distance, 0, rounding);
    const Vector normal({-std::cos(0.1), 0, std::sin(0.1)});
    EXPECT_NEAR((wall.normal - normal).norm(), 0, 1e-13); // rounding
  }
  EXPECT_NEAR(seen(tools, die_wall, die.radius, 0, 4e-3).distance, 0, rounding);
  const double rim_radius = die.radius + 2e-3 * slope;
  EXPECT_GT(seen(tools, die_wall, rim_radius + 1e-4, 0, die.fill_height + 1e-9)
                .distance,
            0);
}

TEST(DieTools, TheCoreRodOfARingHasNoEnds)
{
  DieGeometry die;
  die.shape = DieShape::ring;
  const ToolSurfaces tools = make_tools(die, {});
  for (const double z : {-1., 3e-3, 1.}) {
    const SurfacePoint rod = seen(tools, core_rod, 0, die.core_radius, z);
    EXPECT_NEAR(rod.distance, 0, rounding);
    EXPECT_NEAR((rod.normal - Vector({0, 1, 0})).norm(), 0, 1e-15); // rounding
    EXPECT_NEAR(seen(tools, core_rod, 3e-3, 0, z).distance, 1e-3, rounding);
  }
  EXPECT_TRUE(tools[upper_punch] && tools[lower_punch] && tools[die_wall]);
}

TEST(DieTools, ASquareHasFlatWallsAndRoundEdges)
{
  DieGeometry die;
  die.shape = DieShape::square;
  die.section = Section::quarter;
  const ToolSurfaces tools = make_tools(die, {});
  const double half = die.side / 2, z = die.fill_height / 2;
  EXPECT_NEAR(
      seen(tools, die_wall, half - 1e-4, 0, z).distance, 1e-4, rounding);
  EXPECT_NEAR(
      seen(tools, die_wall, 3e-3, half + 1e-4, z).distance, -1e-4, rounding);
  // On the round edge at 45 degrees, half a corner radius from its centre.
  const double centre = half - die.corner_radius;
  const double at = centre + die.corner_radius / 2 / std::sqrt(2.);
  const SurfacePoint edge = seen(tools, die_wall, at, at, z);
  EXPECT_NEAR(edge.distance, die.corner_radius / 2, rounding);
  const Vector inwards = Vector({-1, -1, 0}) / std::sqrt(2.);
  EXPECT_NEAR((edge.normal - inwards).norm(), 0, 1e-13); // rounding
  // Punches are planes to the corners and beyond; the rim lets go.
  EXPECT_NEAR(
      seen(tools, lower_punch, half, half, 1e-4).distance, 1e-4, rounding);
  EXPECT_NEAR(
      seen(tools, upper_punch, 2 * half, half, z).distance, z, rounding);
  EXPECT_GT(
      seen(tools, die_wall, half + 1e-4, 0, die.fill_height + 1e-9).distance,
      0);
}

TEST(DieTools, ImpossibleDiesAreRefused)
{
  DieGeometry die;
  die.radius = -1;
  EXPECT_THROW(make_tools(die, {}), std::invalid_argument);
}
} // namespace tamp::fem
