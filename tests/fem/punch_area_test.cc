// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/punch_area.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace tamp::fem
{
namespace
{
constexpr double rounding = 1e-12; // relative, of sums over some nodes

DieGeometry cylinder(Section section)
{
  DieGeometry die;
  die.section = section;
  die.radial_elements = 5;
  return die;
}
} // namespace

TEST(PunchArea, OfACylinderIsItsSection)
{
  const DieGeometry die = cylinder(Section::axisymmetric);
  EXPECT_NEAR(punch_area(build_mesh(die), upper_punch) /
                  (std::numbers::pi * die.radius * die.radius),
              1,
              rounding);
}

TEST(MeanHeight, OfAPlaneIsItsHeightOnTheAxis)
{
  // A plane that is tilted about the axis, on the whole of a compact.
  const Mesh mesh = build_mesh(cylinder(Section::full));
  auto positions = mesh.nodes;
  for (auto &place : positions)
    place[2] += 0.1 * place[0] - 0.2 * place[1];
  EXPECT_NEAR(mean_height(mesh, upper_punch, positions), 7e-3, 7e-3 * rounding);
  EXPECT_NEAR(mean_height(mesh, lower_punch, positions), 0, 7e-3 * rounding);
}

TEST(MeanHeight, OfAConeIsAThirdOfItsTip)
{
  const DieGeometry die = cylinder(Section::axisymmetric);
  const Mesh mesh = build_mesh(die);
  auto positions = mesh.nodes;
  for (auto &place : positions)
    place[2] += 1e-3 * (1 - std::abs(place[0]) / die.radius);
  EXPECT_NEAR(mean_height(mesh, upper_punch, positions),
              die.fill_height + 1e-3 / 3,
              die.fill_height * rounding);
}

TEST(MeanHeight, CountsALipByItsArea)
{
  // The outermost node of five bears (2 R + r) (R - r) / (3 R^2) of the area,
  // with r = 4/5 R its inner neighbour.
  const DieGeometry die = cylinder(Section::axisymmetric);
  const Mesh mesh = build_mesh(die);
  auto positions = mesh.nodes;
  for (const unsigned node : mesh.tools[upper_punch].nodes)
    if (positions[node][0] > 0.99 * die.radius)
      positions[node][2] += 1e-3;
  EXPECT_NEAR(mean_height(mesh, upper_punch, positions),
              die.fill_height + 1e-3 * 2.8 * 0.2 / 3,
              die.fill_height * rounding);
}
} // namespace tamp::fem
