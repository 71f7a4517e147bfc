// SPDX-License-Identifier: BSD-3-Clause
#include <fem/die_geometry.h>

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Kind = PunchFace::Kind;
using Change = std::function<void(DieGeometry &)>;

/// What check() says of the default die after a change; empty if nothing.
std::string complaint(const Change &change)
{
  DieGeometry die;
  change(die);
  try {
    die.check();
  } catch (const std::invalid_argument &error) {
    return error.what();
  }
  return "";
}

void expect_refused(const std::string &beginning, const Change &change)
{
  const std::string text = complaint(change);
  EXPECT_EQ(text.substr(0, beginning.size()), beginning);
  EXPECT_NE(text.find("; expected "), std::string::npos) << text;
}

void make_square(DieGeometry &die)
{
  die.shape = DieShape::square;
  die.section = Section::quarter;
}
} // namespace

TEST(DieGeometry, PossibleDiesAreAccepted)
{
  EXPECT_EQ(complaint([](DieGeometry &) {}), "");
  EXPECT_EQ(complaint([](DieGeometry &die) { make_square(die); }), "");
  EXPECT_EQ(complaint([](DieGeometry &die) {
              make_square(die);
              die.corner_radius = die.side / 2;
            }),
            "");
  EXPECT_EQ(complaint([](DieGeometry &die) {
              die.shape = DieShape::ring;
              die.upper_face = {Kind::concave, 10e-3, 0, 0};
              die.lower_face = {Kind::bevel, 0, 1e-3, 0.5};
              die.exit_taper_angle = 0.02;
              die.exit_taper_length = 3e-3;
            }),
            "");
  EXPECT_EQ(complaint([](DieGeometry &die) {
              die.shape = DieShape::file;
              die.mesh_file = "powder.msh";
            }),
            "");
}

TEST(DieGeometry, ImpossibleSizesAreRefusedByName)
{
  expect_refused("radius is 0;", [](DieGeometry &die) { die.radius = 0; });
  expect_refused("radius is nan;", [](DieGeometry &die) {
    die.radius = std::numeric_limits<double>::quiet_NaN();
  });
  expect_refused("fill height is inf;", [](DieGeometry &die) {
    die.fill_height = std::numeric_limits<double>::infinity();
  });
  expect_refused("core radius is 0.006;", [](DieGeometry &die) {
    die.shape = DieShape::ring;
    die.core_radius = die.radius;
  });
  expect_refused("core radius is 0;", [](DieGeometry &die) {
    die.shape = DieShape::ring;
    die.core_radius = 0;
  });
  expect_refused("side is -1;", [](DieGeometry &die) {
    make_square(die);
    die.side = -1;
  });
  expect_refused("corner radius is 0.007;", [](DieGeometry &die) {
    make_square(die);
    die.corner_radius = 7e-3;
  });
  expect_refused("radial elements is 0;",
                 [](DieGeometry &die) { die.radial_elements = 0; });
  expect_refused("axial elements is 0;",
                 [](DieGeometry &die) { die.axial_elements = 0; });
}

TEST(DieGeometry, ImpossibleFacesAreRefusedByName)
{
  expect_refused("upper punch: radius is 0.006;", [](DieGeometry &die) {
    die.upper_face = {Kind::concave, 6e-3, 0, 0};
  });
  expect_refused("lower punch: radius is 0.005;", [](DieGeometry &die) {
    die.lower_face = {Kind::convex, 5e-3, 0, 0};
  });
  // A cup of radius 6.25 mm is 6.25 - sqrt(6.25^2 - 6^2) = 4.5 mm deep.
  expect_refused("lower punch: depth is 0.0045;", [](DieGeometry &die) {
    die.lower_face = {Kind::concave, 6.25e-3, 0, 0};
  });
  expect_refused("upper punch: depth is 0.0045;", [](DieGeometry &die) {
    die.upper_face = {Kind::convex, 6.25e-3, 0, 0};
  });
  expect_refused("upper punch: width of the rim is 0;", [](DieGeometry &die) {
    die.upper_face = {Kind::chamfer, 0, 0, 0};
  });
  expect_refused("upper punch: width of the rim is 0.005;",
                 [](DieGeometry &die) {
                   die.shape = DieShape::ring;
                   die.upper_face = {Kind::chamfer, 0, 5e-3, 0};
                 });
  expect_refused("upper punch: depth is 0.004;", [](DieGeometry &die) {
    die.upper_face = {Kind::chamfer, 0, 4e-3, 0};
  });
  expect_refused("lower punch: angle of the rim is 0;", [](DieGeometry &die) {
    die.lower_face = {Kind::bevel, 0, 1e-3, 0};
  });
  expect_refused("lower punch: angle of the rim is 1.6;", [](DieGeometry &die) {
    die.lower_face = {Kind::bevel, 0, 1e-3, 1.6};
  });
}

TEST(DieGeometry, ImpossibleTapersAreRefusedByName)
{
  expect_refused("exit taper angle is -0.1;",
                 [](DieGeometry &die) { die.exit_taper_angle = -0.1; });
  expect_refused("exit taper angle is 0.785398;", [](DieGeometry &die) {
    die.exit_taper_angle = std::numbers::pi / 4;
    die.exit_taper_length = 1e-3;
  });
  expect_refused("exit taper length is 0;",
                 [](DieGeometry &die) { die.exit_taper_angle = 0.1; });
  expect_refused("exit taper length is 0.007;", [](DieGeometry &die) {
    die.exit_taper_angle = 0.1;
    die.exit_taper_length = die.fill_height;
  });
  expect_refused("exit taper length is -1;",
                 [](DieGeometry &die) { die.exit_taper_length = -1; });
}

TEST(DieGeometry, CombinationsWithoutSenseAreRefused)
{
  expect_refused("section is 0;",
                 [](DieGeometry &die) { die.shape = DieShape::square; });
  expect_refused("upper punch: kind of face is 2;", [](DieGeometry &die) {
    make_square(die);
    die.upper_face = {Kind::concave, 20e-3, 0, 0};
  });
  expect_refused("exit taper angle is 0.1;", [](DieGeometry &die) {
    make_square(die);
    die.exit_taper_angle = 0.1;
    die.exit_taper_length = 1e-3;
  });
  expect_refused("mesh file is empty;",
                 [](DieGeometry &die) { die.shape = DieShape::file; });
  expect_refused("lower punch: kind of face is 3;", [](DieGeometry &die) {
    die.shape = DieShape::file;
    die.mesh_file = "powder.msh";
    die.lower_face = {Kind::chamfer, 0, 1e-3, 0};
  });
}

TEST(PunchFace, HeightsAreThoseOfTheDrawing)
{
  // Domes of radius 5 over an edge at 3 are 5 - 4 high; 3-4-5 triangles.
  const PunchFace convex{Kind::convex, 5, 0, 0},
      concave{Kind::concave, 5, 0, 0};
  const PunchFace chamfer{Kind::chamfer, 0, 0.5, 0};
  const PunchFace bevel{Kind::bevel, 0, 0.5, std::atan(0.25)};
  constexpr double tolerance = 1e-15; // rounding
  EXPECT_NEAR(convex.height(0, 3), 1, tolerance);
  EXPECT_NEAR(convex.height(3, 3), 0, tolerance);
  EXPECT_NEAR(convex.height(3.1, 3), -0.1 * 3 / 4, tolerance);
  EXPECT_NEAR(convex.height(1.4, 3), 4.8 - 4, tolerance);
  EXPECT_NEAR(concave.height(1.4, 3), 4 - 4.8, tolerance);
  EXPECT_NEAR(chamfer.height(0, 3), -0.5, tolerance);
  EXPECT_NEAR(chamfer.height(2.7, 3), -0.3, tolerance);
  EXPECT_NEAR(bevel.height(1, 3), -0.125, tolerance);
  EXPECT_NEAR(bevel.height(3.2, 3), 0.05, tolerance);
  EXPECT_EQ(PunchFace{}.height(1, 3), 0);
}
} // namespace tamp::fem
