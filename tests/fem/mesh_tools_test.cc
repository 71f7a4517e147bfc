// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_tools.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Vector = dealii::Tensor<1, 3>;
using Line = std::vector<std::array<double, 2>>;

/// Adds faces and the nodes on them to a tool.
void add_faces(Mesh &mesh, Tool tool, const std::vector<unsigned> &faces)
{
  auto &contact = mesh.tools[tool];
  contact.faces.insert(contact.faces.end(), faces.begin(), faces.end());
  contact.nodes = contact.faces;
  std::sort(contact.nodes.begin(), contact.nodes.end());
  const auto last = std::unique(contact.nodes.begin(), contact.nodes.end());
  contact.nodes.erase(last, contact.nodes.end());
}

/// Adds a tool's edges in the plane y = 0, in no order.
void add_line(Mesh &mesh, Tool tool, const Line &line)
{
  const auto first = static_cast<unsigned>(mesh.nodes.size());
  std::vector<std::array<unsigned, 2>> edges;
  for (unsigned i = 0; i < line.size(); ++i) {
    mesh.nodes.push_back(Vector({line[i][0], 0, line[i][1]}));
    if (i > 0)
      edges.push_back({first + i - i % 2, first + i - 1 + i % 2});
  }
  std::shuffle(edges.begin(), edges.end(), std::mt19937(3));
  std::vector<unsigned> faces;
  for (const auto &edge : edges)
    faces.insert(faces.end(), edge.begin(), edge.end());
  add_faces(mesh, tool, faces);
}

/// Points on a straight line, both ends included.
Line straight(double r0, double z0, double r1, double z1, unsigned sides)
{
  Line line;
  for (unsigned i = 0; i <= sides; ++i) {
    const double share = static_cast<double>(i) / sides;
    line.push_back({r0 + share * (r1 - r0), z0 + share * (z1 - z0)});
  }
  return line;
}

/// The surface of the default die, axisymmetric.
Mesh cylinder()
{
  Mesh mesh;
  add_line(mesh, lower_punch, straight(0, 0, 6e-3, 0, 4));
  add_line(mesh, upper_punch, straight(6e-3, 7e-3, 0, 7e-3, 4));
  add_line(mesh, die_wall, straight(6e-3, 7e-3, 6e-3, 0, 7));
  return mesh;
}

/// The surface of a prism between two outlines of nodes, with faces along the
/// outline as the wall, and punches at its ends.
Mesh prism(const Line &outline, bool closed, double height)
{
  Mesh mesh;
  mesh.section = closed ? Section::full : Section::quarter;
  for (const double z : {0., height})
    for (const auto &[x, y] : outline)
      mesh.nodes.push_back(Vector({x, y, z}));
  const auto size = static_cast<unsigned>(outline.size());
  for (unsigned i = 0; i + (closed ? 0 : 1) < size; ++i) {
    const unsigned next = (i + 1) % size;
    add_faces(mesh, die_wall, {i, next, size + i, size + next});
  }
  for (unsigned i = 0; i + 3 < size; ++i) {
    add_faces(mesh, lower_punch, {i, i + 1, i + 2, i + 3});
    add_faces(mesh,
              upper_punch,
              {size + i, size + i + 1, size + i + 2, size + i + 3});
  }
  return mesh;
}

Line circle(double radius, double angle, unsigned sides)
{
  Line line;
  for (unsigned i = 0; i < sides; ++i)
    line.push_back({radius * std::cos(angle * i / sides),
                    radius * std::sin(angle * i / sides)});
  return line;
}

double
distance(const ToolSurfaces &tools, Tool tool, double x, double y, double z)
{
  return tools[tool]->nearest(Vector({x, y, z})).distance;
}

std::string complaint(const Mesh &mesh)
{
  try {
    tools_of_mesh(mesh);
  } catch (const std::runtime_error &error) {
    return error.what();
  }
  return "";
}

constexpr double rounding = 1e-16; // of lengths of some mm
} // namespace

TEST(MeshTools, OfACylinderAreThoseOfTheBuiltInDie)
{
  const ToolSurfaces read = tools_of_mesh(cylinder());
  const ToolSurfaces built_in = make_tools({}, {});
  EXPECT_FALSE(read[core_rod]);
  for (const Tool tool : {upper_punch, lower_punch, die_wall})
    for (const double x : {-8e-3, -3e-3, 0., 2e-3, 6e-3, 7e-3})
      for (const double y : {0., 1e-3, 5e-3})
        for (const double z : {-9e-3, 0., 3e-3, 7e-3, 8e-3}) {
          const Vector place({x, y, z});
          EXPECT_NEAR(read[tool]->nearest(place).distance,
                      built_in[tool]->nearest(place).distance,
                      rounding)
              << tool_names[tool] << " at " << place;
        }
}

TEST(MeshTools, OfAStepFollowTheStep)
{
  // The bore narrows to 4 mm at z = 3 mm, with a level step; its nodes reach
  // up to 5 mm, the upper punch is at 6 mm.
  Mesh mesh;
  add_line(mesh, lower_punch, straight(0, 0, 4e-3, 0, 3));
  add_line(mesh, upper_punch, straight(0, 6e-3, 6e-3, 6e-3, 3));
  Line wall = straight(4e-3, 0, 4e-3, 3e-3, 3);
  for (const auto &more : {straight(4e-3, 3e-3, 6e-3, 3e-3, 2),
                           straight(6e-3, 3e-3, 6e-3, 5e-3, 2)})
    wall.insert(wall.end(), more.begin() + 1, more.end());
  add_line(mesh, die_wall, wall);
  const ToolSurfaces tools = tools_of_mesh(mesh);
  EXPECT_NEAR(distance(tools, die_wall, 3e-3, 0, -1), 1e-3, rounding);
  EXPECT_NEAR(distance(tools, die_wall, 4.5e-3, 0, 3.1e-3), 1e-4, rounding);
  EXPECT_NEAR(distance(tools, die_wall, 4.5e-3, 0, 2.9e-3), -1e-4, rounding);
  EXPECT_NEAR(distance(tools, die_wall, 6.1e-3, 0, 5.5e-3), -1e-4, rounding);
  EXPECT_GT(distance(tools, die_wall, 6.1e-3, 0, 6.01e-3), 0);
  // Off the step's edge, which stands out: a 3-4-5 triangle.
  EXPECT_NEAR(distance(tools, die_wall, 3.7e-3, 0, 3.4e-3), 5e-4, rounding);
}

TEST(MeshTools, OfADomeIsTheDome)
{
  DieGeometry die;
  die.upper_face = {PunchFace::Kind::concave, 8e-3, 0, 0};
  die.lower_face = {PunchFace::Kind::convex, 20e-3, 0, 0};
  Mesh mesh = cylinder();
  mesh.tools[upper_punch] = mesh.tools[lower_punch] = {};
  constexpr unsigned sides = 6;
  Line lower, upper;
  for (unsigned i = 0; i <= sides; ++i) {
    const double r = die.radius * i / sides;
    lower.push_back({r, die.lower_face.height(r, die.radius)});
    upper.push_back({r, 7e-3 - die.upper_face.height(r, die.radius)});
  }
  add_line(mesh, lower_punch, lower);
  add_line(mesh, upper_punch, upper);
  const ToolSurfaces read = tools_of_mesh(mesh);
  const ToolSurfaces built_in = make_tools(die, {});
  constexpr double tolerance = 1e-15; // rounding of lengths of some mm
  for (const double r : {0., 1e-5, 1.23e-3, 4.56e-3, 5.6e-3})
    for (const double off : {-2e-4, 0., 1e-5, 3e-4})
      for (const Tool tool : {upper_punch, lower_punch}) {
        const bool up = tool == upper_punch;
        const PunchFace &face = up ? die.upper_face : die.lower_face;
        const double height = face.height(r, die.radius) + off;
        const double z = up ? 7e-3 - height : height;
        EXPECT_NEAR(distance(read, tool, 0.6 * r, 0.8 * r, z),
                    distance(built_in, tool, 0.6 * r, 0.8 * r, z),
                    tolerance)
            << tool_names[tool] << " at " << r << ", " << z;
      }
}

TEST(MeshTools, OfARingHaveARodWithoutEnds)
{
  Mesh mesh;
  add_line(mesh, lower_punch, straight(2e-3, 0, 6e-3, 0, 2));
  add_line(mesh, upper_punch, straight(2e-3, 7e-3, 6e-3, 7e-3, 2));
  add_line(mesh, die_wall, straight(6e-3, 0, 6e-3, 7e-3, 2));
  add_line(mesh, core_rod, straight(2e-3, 0, 2e-3, 7e-3, 2));
  const ToolSurfaces tools = tools_of_mesh(mesh);
  for (const double z : {-1., 3e-3, 1.}) {
    EXPECT_NEAR(distance(tools, core_rod, 3e-3, 0, z), 1e-3, rounding);
    EXPECT_NEAR(distance(tools, core_rod, 0, 1.9e-3, z), -1e-4, rounding);
  }
  EXPECT_NEAR(distance(tools, lower_punch, 1e-3, 0, 1e-3), 1e-3, rounding);
}

TEST(MeshTools, InSpaceCylindersAndRectanglesAreFound)
{
  const double turn = 2 * std::numbers::pi;
  for (const Mesh &mesh : {prism(circle(6e-3, turn, 12), true, 7e-3),
                           prism(circle(6e-3, turn, 4), true, 7e-3),
                           prism(circle(6e-3, turn / 4, 5), false, 7e-3)}) {
    const ToolSurfaces tools = tools_of_mesh(mesh);
    EXPECT_NEAR(distance(tools, die_wall, 3e-3, 4e-3, 2e-3), 1e-3, rounding);
    EXPECT_NEAR(distance(tools, upper_punch, 3e-3, 4e-3, 2e-3), 5e-3, rounding);
    EXPECT_NEAR(distance(tools, lower_punch, 3e-3, 4e-3, 2e-3), 2e-3, rounding);
  }
  const double x = 6e-3, y = 4e-3;
  for (const Mesh &mesh :
       {prism({{x, y}, {-x, y}, {-x, -y}, {x, -y}}, true, 7e-3),
        prism({{x, 0}, {x, y / 2}, {x, y}, {0, y}}, false, 7e-3)}) {
    const ToolSurfaces tools = tools_of_mesh(mesh);
    EXPECT_NEAR(distance(tools, die_wall, 3e-3, 3.9e-3, 2e-3), 1e-4, rounding);
    EXPECT_NEAR(distance(tools, die_wall, 6.1e-3, 1e-3, 2e-3), -1e-4, rounding);
    EXPECT_GT(distance(tools, die_wall, 6.1e-3, 1e-3, 7.1e-3), 0);
  }
}

TEST(MeshTools, InSpaceARoundedRectangleIsFound)
{
  // A quarter of 12 mm x 10 mm whose corner has a radius of 2 mm.
  Line outline{{6e-3, 0}, {6e-3, 3e-3}};
  for (const double degrees : {22.5, 45., 90.}) {
    const double angle = degrees * std::numbers::pi / 180;
    outline.push_back(
        {4e-3 + 2e-3 * std::cos(angle), 3e-3 + 2e-3 * std::sin(angle)});
  }
  outline.push_back({0, 5e-3});
  Mesh mesh = prism(outline, false, 7e-3);
  const ToolSurfaces tools = tools_of_mesh(mesh);
  constexpr double tolerance = 1e-14; // rounding in the radius of the arc
  EXPECT_NEAR(distance(tools, die_wall, 5.9e-3, 1e-3, 2e-3), 1e-4, tolerance);
  EXPECT_NEAR(distance(tools, die_wall, 1e-3, 5.1e-3, 2e-3), -1e-4, tolerance);
  // 3-4-5 from the middle of the arc.
  EXPECT_NEAR(distance(tools, die_wall, 4.9e-3, 4.2e-3, 2e-3), 5e-4, tolerance);
  mesh.nodes[2][0] += 1e-4;
  EXPECT_NE(complaint(mesh), "");
}

TEST(MeshTools, OtherShapesAreRefusedByName)
{
  const auto expect = [](const std::string &beginning, const Mesh &mesh) {
    const std::string text = complaint(mesh);
    EXPECT_EQ(text.substr(0, beginning.size()), beginning);
  };
  const double turn = 2 * std::numbers::pi;
  Mesh mesh = prism(circle(6e-3, turn, 12), true, 7e-3);
  mesh.nodes[1] *= 1.001;
  expect("mesh: die_wall goes through x = ", mesh);
  mesh = prism(circle(6e-3, turn, 12), true, 7e-3);
  mesh.nodes[14][2] += 1e-6;
  expect("mesh: punch_top has nodes at z = 0.007 m and z = 0.007001 m", mesh);
  mesh = prism(circle(6e-3, turn, 12), true, 7e-3);
  mesh.tools[core_rod] = mesh.tools[die_wall];
  EXPECT_EQ(complaint(mesh), "");
  mesh.tools[core_rod] = mesh.tools[lower_punch];
  mesh.nodes.push_back(Vector());
  mesh.tools[core_rod].nodes.push_back(24);
  expect("mesh: core has nodes closer to the z axis than 0.006 m", mesh);
  mesh.tools[die_wall] = {};
  expect("mesh: die_wall has no faces; expected some", mesh);
}

TEST(MeshTools, BrokenLinesAreRefusedByName)
{
  Mesh mesh = cylinder();
  add_line(mesh, die_wall, straight(6e-3, 8e-3, 6e-3, 9e-3, 1));
  EXPECT_EQ(complaint(mesh),
            "mesh: die_wall is not one line of edges from end to end");
  mesh = cylinder();
  add_faces(mesh, lower_punch, {1, 7});
  EXPECT_EQ(complaint(mesh),
            "mesh: punch_bottom branches; expected one line of edges");
}
} // namespace tamp::fem
