// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/mesh_faces.h>
#include <fem/mesh_quality.h>
#include <fem/tool_surface.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
constexpr double pi = std::numbers::pi;
/// Rounding of some hundred sums.
constexpr double rounding = 1e-12;

DieGeometry die(DieShape shape, Section section, unsigned elements)
{
  DieGeometry geometry;
  geometry.shape = shape;
  geometry.section = section;
  geometry.radial_elements = elements;
  geometry.axial_elements = elements;
  return geometry;
}

/// Every shape in every section it has.
std::vector<DieGeometry> all_dies(unsigned elements)
{
  std::vector<DieGeometry> dies;
  for (const Section section :
       {Section::axisymmetric, Section::quarter, Section::full}) {
    dies.push_back(die(DieShape::cylinder, section, elements));
    dies.push_back(die(DieShape::ring, section, elements));
    if (section == Section::axisymmetric)
      continue;
    for (const double corner : {0., 0.2e-3, 1e-3, 3e-3, 5.9e-3, 6e-3}) {
      dies.push_back(die(DieShape::square, section, elements));
      dies.back().corner_radius = corner;
    }
  }
  return dies;
}

std::string name_of(const DieGeometry &geometry)
{
  return "shape " + std::to_string(static_cast<int>(geometry.shape)) +
         ", section " + std::to_string(static_cast<int>(geometry.section)) +
         ", corner " + std::to_string(geometry.corner_radius) + ", " +
         std::to_string(geometry.radial_elements) + " elements";
}

double exact_volume(const DieGeometry &geometry)
{
  const double r = geometry.radius, c = geometry.core_radius;
  switch (geometry.shape) {
  case DieShape::cylinder:
    return pi * r * r * geometry.fill_height;
  case DieShape::ring:
    return pi * (r * r - c * c) * geometry.fill_height;
  default:
    return (geometry.side * geometry.side -
            (4 - pi) * geometry.corner_radius * geometry.corner_radius) *
           geometry.fill_height;
  }
}

double volume(const DieGeometry &geometry)
{
  const Mesh mesh = build_mesh(geometry);
  return mesh.multiplicity() * mesh_volume(mesh);
}

double volume_error(const DieGeometry &geometry)
{
  return std::abs(volume(geometry) / exact_volume(geometry) - 1);
}

/// Distance of a place from the outline of a rounded square.
double outline_distance(const DieGeometry &geometry,
                        const dealii::Tensor<1, 3> &place)
{
  const double straight = geometry.side / 2 - geometry.corner_radius;
  const double x = std::abs(place[0]) - straight;
  const double y = std::abs(place[1]) - straight;
  const double distance = x > 0 && y > 0 ? std::hypot(x, y) : std::max(x, y);
  return std::abs(distance - geometry.corner_radius);
}
} // namespace

TEST(BuildMesh, CylinderIsNumberedFromBelowWithTheRadiusFastest)
{
  DieGeometry geometry;
  geometry.radial_elements = 3;
  geometry.axial_elements = 7;
  const Mesh mesh = build_mesh(geometry);
  ASSERT_EQ(mesh.nodes.size(), 32u);
  // Exactly: results of the same mesh keep their bits.
  for (unsigned n = 0; n < 32; ++n) {
    EXPECT_EQ(mesh.nodes[n][0], n % 4 * (geometry.radius / 3));
    EXPECT_EQ(mesh.nodes[n][1], 0);
    EXPECT_EQ(mesh.nodes[n][2], n / 4 * (geometry.fill_height / 7));
  }
  ASSERT_EQ(mesh.number_of_cells(), 21u);
  const unsigned *fourth = mesh.nodes_of_cell(4);
  EXPECT_EQ(std::vector<unsigned>(fourth, fourth + 4),
            (std::vector<unsigned>{5, 6, 9, 10}));
  EXPECT_EQ(mesh.tools[die_wall].nodes.size(), 8u);
  EXPECT_EQ(mesh.tools[upper_punch].nodes,
            (std::vector<unsigned>{28, 29, 30, 31}));
  EXPECT_EQ(mesh.tools[lower_punch].nodes, (std::vector<unsigned>{0, 1, 2, 3}));
  EXPECT_TRUE(mesh.tools[core_rod].nodes.empty());
}

TEST(BuildMesh, StraightOutlinesHaveTheExactVolume)
{
  EXPECT_LT(volume_error(die(DieShape::cylinder, Section::axisymmetric, 5)),
            rounding);
  EXPECT_LT(volume_error(die(DieShape::ring, Section::axisymmetric, 5)),
            rounding);
  DieGeometry square = die(DieShape::square, Section::quarter, 5);
  square.corner_radius = 0;
  EXPECT_LT(volume_error(square), rounding);
}

TEST(BuildMesh, VolumeConvergesToThatOfRoundOutlines)
{
  for (DieGeometry geometry : all_dies(8)) {
    const double coarse = volume_error(geometry);
    geometry.radial_elements *= 2;
    const double fine = volume_error(geometry);
    // Chords miss a round outline by the square of their length: a quarter. Of
    // a small arc they may first miss all.
    EXPECT_LT(fine, coarse / 2 + rounding) << name_of(geometry);
    EXPECT_LT(fine, 2e-3) << name_of(geometry);
  }
}

TEST(BuildMesh, DomesTakeTheVolumeOfTheirCaps)
{
  DieGeometry geometry = die(DieShape::cylinder, Section::axisymmetric, 8);
  geometry.lower_face.kind = PunchFace::Kind::convex;
  geometry.lower_face.radius = 9e-3;
  geometry.upper_face.kind = PunchFace::Kind::concave;
  geometry.upper_face.radius = 15e-3;
  const auto cap = [&](double radius) {
    const double h =
        radius - std::sqrt(radius * radius - geometry.radius * geometry.radius);
    return pi * h * h * (3 * radius - h) / 3;
  };
  const double exact = exact_volume(geometry) - cap(9e-3) + cap(15e-3);
  for (const Section section : {Section::axisymmetric, Section::quarter}) {
    geometry.section = section;
    geometry.radial_elements = 8;
    const double coarse = std::abs(volume(geometry) - exact);
    geometry.radial_elements = 16;
    // Second order: a quarter, and 13 chords for 6 in the section.
    EXPECT_LT(std::abs(volume(geometry) - exact), coarse / 3.5);
    EXPECT_LT(coarse, 0.02 * exact);
  }
}

TEST(BuildMesh, ColumnsStandAtTheInnerEdgesOfRims)
{
  DieGeometry geometry = die(DieShape::cylinder, Section::axisymmetric, 5);
  const double w = 0.7e-3, v = 2e-3, r = geometry.radius;
  geometry.lower_face.kind = PunchFace::Kind::chamfer;
  geometry.lower_face.width = w;
  geometry.upper_face.kind = PunchFace::Kind::bevel;
  geometry.upper_face.width = v;
  geometry.upper_face.angle = 0.3;
  // A recess as deep as d that rises along a rim of width b.
  const auto recess = [&](double b, double d) {
    return pi * d * (r * r - r * b + b * b / 3);
  };
  EXPECT_NEAR(volume(geometry),
              exact_volume(geometry) + recess(w, w) +
                  recess(v, v * std::tan(0.3)),
              rounding * exact_volume(geometry));
}

TEST(BuildMesh, CellsAreWellShaped)
{
  // A single element in the quarter of a disc has a corner of 135 degrees, 0.7.
  for (const unsigned elements : {1u, 2u, 3u, 4u, 5u, 7u, 10u, 16u})
    for (const DieGeometry &geometry : all_dies(elements))
      EXPECT_GT(mesh_quality(build_mesh(geometry)).scaled_jacobian, 0.6)
          << name_of(geometry);
}

TEST(BuildMesh, EveryFaceOfTheBoundaryHasOneOwner)
{
  for (const DieGeometry &geometry : all_dies(3)) {
    const Mesh mesh = build_mesh(geometry);
    const unsigned per_face = mesh.nodes_per_face();
    std::map<FaceKey, unsigned> owners;
    for (const Mesh::Contact &tool : mesh.tools)
      for (std::size_t i = 0; i < tool.faces.size(); i += per_face) {
        FaceKey nodes{};
        std::copy_n(&tool.faces[i], per_face, nodes.begin());
        ++owners[face_key(nodes, per_face)];
      }
    std::set<std::pair<unsigned, unsigned>> held;
    for (const Mesh::Held &one : mesh.held)
      held.insert({one.node, one.axis});
    for (const MeshFace &face : boundary_faces(mesh)) {
      unsigned count = owners[face_key(face.nodes, per_face)];
      for (const unsigned axis : {0u, 1u})
        count += mesh.section != Section::full &&
                 std::all_of(face.nodes.begin(),
                             face.nodes.begin() + per_face,
                             [&](unsigned node) {
                               return held.count({node, axis}) > 0;
                             });
      EXPECT_EQ(count, 1u) << name_of(geometry);
    }
    EXPECT_EQ(mesh.tools[core_rod].faces.empty(),
              geometry.shape != DieShape::ring);
  }
}

TEST(BuildMesh, NodesOfToolsLieOnTheTools)
{
  for (DieGeometry geometry : all_dies(4)) {
    if (geometry.shape != DieShape::square) {
      geometry.lower_face.kind = PunchFace::Kind::convex;
      geometry.lower_face.radius = 20e-3;
    }
    const Mesh mesh = build_mesh(geometry);
    const double tolerance = rounding * geometry.radius;
    const auto radius_of = [&](unsigned node) {
      return std::hypot(mesh.nodes[node][0], mesh.nodes[node][1]);
    };
    for (const unsigned node : mesh.tools[die_wall].nodes)
      EXPECT_LT(geometry.shape == DieShape::square
                    ? outline_distance(geometry, mesh.nodes[node])
                    : std::abs(radius_of(node) - geometry.radius),
                tolerance);
    for (const unsigned node : mesh.tools[core_rod].nodes)
      EXPECT_NEAR(radius_of(node), geometry.core_radius, tolerance);
    for (const unsigned node : mesh.tools[upper_punch].nodes)
      EXPECT_NEAR(mesh.nodes[node][2], geometry.fill_height, tolerance);
    for (const unsigned node : mesh.tools[lower_punch].nodes)
      EXPECT_NEAR(mesh.nodes[node][2],
                  geometry.lower_face.height(radius_of(node), geometry.radius),
                  tolerance);
  }
}

TEST(BuildMesh, ToolsTouchTheirNodesAndHoldNoOthers)
{
  using Kind = PunchFace::Kind;
  for (DieGeometry geometry : all_dies(6))
    for (const Kind kind : {Kind::flat,
                            Kind::convex,
                            Kind::concave,
                            Kind::chamfer,
                            Kind::bevel}) {
      if (geometry.shape == DieShape::square && kind != Kind::flat)
        continue;
      geometry.lower_face = {kind, 10e-3, 1e-3, 0.5};
      geometry.upper_face = {kind, 8e-3, 2e-3, 0.3};
      const Mesh mesh = build_mesh(geometry);
      const ToolSurfaces tools = make_tools(geometry, mesh);
      const double tolerance = rounding * geometry.radius;
      for (unsigned tool = 0; tool < number_of_tools; ++tool) {
        if (!tools[tool])
          continue;
        for (const unsigned node : mesh.tools[tool].nodes)
          EXPECT_NEAR(
              tools[tool]->nearest(mesh.nodes[node]).distance, 0, tolerance)
              << name_of(geometry);
        for (const auto &node : mesh.nodes)
          EXPECT_GT(tools[tool]->nearest(node).distance, -tolerance)
              << name_of(geometry);
      }
    }
}

TEST(BuildMesh, HeldAreAxisAndPlanesOfSymmetry)
{
  for (const DieGeometry &geometry : all_dies(3)) {
    const Mesh mesh = build_mesh(geometry);
    std::size_t expected = 0;
    for (const auto &node : mesh.nodes) {
      const bool x = node[0] == 0, y = node[1] == 0;
      if (mesh.section == Section::axisymmetric)
        expected += x;
      else if (mesh.section == Section::quarter)
        expected += x + y;
      else
        expected += x && y ? 2 : 0;
    }
    EXPECT_EQ(mesh.held.size(), expected) << name_of(geometry);
    for (const Mesh::Held &held : mesh.held)
      EXPECT_EQ(mesh.nodes[held.node][held.axis], 0);
    EXPECT_TRUE(mesh.held.size() >= 4 || geometry.shape == DieShape::ring);
  }
}

TEST(BuildMesh, FullMeshIsFourQuarters)
{
  for (DieGeometry geometry : all_dies(4)) {
    if (geometry.section != Section::quarter)
      continue;
    const Mesh quarter = build_mesh(geometry);
    geometry.section = Section::full;
    const Mesh full = build_mesh(geometry);
    EXPECT_EQ(full.number_of_cells(), 4 * quarter.number_of_cells());
    EXPECT_NEAR(mesh_volume(full) / mesh_volume(quarter), 4, 4 * rounding);
    // Slices from below.
    const std::size_t base = full.nodes.size() / 5;
    for (std::size_t n = 0; n < full.nodes.size(); ++n)
      EXPECT_NEAR(full.nodes[n][2],
                  geometry.fill_height / 4 * static_cast<double>(n / base),
                  rounding * geometry.fill_height);
  }
}

TEST(BuildMesh, FilesAreNotBuilt)
{
  DieGeometry geometry;
  geometry.shape = DieShape::file;
  geometry.mesh_file = "some.msh";
  EXPECT_THROW(build_mesh(geometry), std::invalid_argument);
}
} // namespace tamp::fem
