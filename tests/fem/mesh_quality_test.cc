// SPDX-License-Identifier: BSD-3-Clause
#include <fem/mesh_quality.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace tamp::fem
{
namespace
{
using Vector = dealii::Tensor<1, 3>;
/// Rounding of some sums.
constexpr double rounding = 1e-14;

/// A single hexahedron, the unit cube under a linear map.
Mesh parallelepiped(const Vector &a, const Vector &b, const Vector &c)
{
  Mesh mesh;
  mesh.section = Section::full;
  for (unsigned v = 0; v < 8; ++v) {
    mesh.nodes.push_back((v & 1) * a + (v >> 1 & 1) * b + (v >> 2) * c);
    mesh.cells.push_back(v);
  }
  return mesh;
}

Mesh quadrilateral(const std::vector<Vector> &nodes)
{
  Mesh mesh;
  mesh.nodes = nodes;
  mesh.cells = {0, 1, 2, 3};
  return mesh;
}
} // namespace

TEST(MeshQuality, BrickIsPerfect)
{
  const Mesh mesh =
      parallelepiped(Vector({2, 0, 0}), Vector({0, 3, 0}), Vector({0, 0, 5}));
  const MeshQuality quality = mesh_quality(mesh);
  EXPECT_NEAR(quality.scaled_jacobian, 1, rounding);
  EXPECT_NEAR(quality.aspect_ratio, 2.5, rounding);
  EXPECT_NEAR(quality.shortest_edge, 2, rounding);
  EXPECT_NEAR(quality.longest_edge, 5, rounding);
  EXPECT_NEAR(mesh_volume(mesh), 30, 30 * rounding);
}

TEST(MeshQuality, ShearedCellHasTheSineOfItsAngle)
{
  const double angle = 0.4;
  const Mesh mesh =
      parallelepiped(Vector({1, 0, 0}),
                     Vector({std::cos(angle), std::sin(angle), 0}),
                     Vector({0, 0, 1}));
  EXPECT_NEAR(mesh_quality(mesh).scaled_jacobian, std::sin(angle), rounding);
  EXPECT_NEAR(mesh_volume(mesh), std::sin(angle), rounding);
}

TEST(MeshQuality, InvertedCellsAreNegative)
{
  EXPECT_NEAR(mesh_quality(parallelepiped(Vector({0, 1, 0}),
                                          Vector({1, 0, 0}),
                                          Vector({0, 0, 1})))
                  .scaled_jacobian,
              -1,
              rounding);
  // A quadrilateral that is concave at its last corner.
  EXPECT_LT(mesh_quality(quadrilateral({Vector({0, 0, 0}),
                                        Vector({1, 0, 0}),
                                        Vector({0, 0, 1}),
                                        Vector({0.2, 0, 0.2})}))
                .scaled_jacobian,
            0);
}

TEST(MeshQuality, ConeHasItsVolume)
{
  // A trapezium turned about the axis: a truncated cone of radii 3 and 1.
  const Mesh mesh = quadrilateral({Vector({0, 0, 0}),
                                   Vector({3, 0, 0}),
                                   Vector({0, 0, 2}),
                                   Vector({1, 0, 2})});
  const double exact = std::numbers::pi * 2 / 3 * (9 + 3 + 1);
  EXPECT_NEAR(mesh_volume(mesh), exact, exact * rounding);
}

TEST(MeshQuality, PyramidFrustumHasItsVolume)
{
  // Not a linear map: the determinant is of second order along the height.
  Mesh mesh =
      parallelepiped(Vector({2, 0, 0}), Vector({0, 2, 0}), Vector({0, 0, 3}));
  for (unsigned v = 4; v < 8; ++v)
    for (unsigned axis = 0; axis < 2; ++axis)
      mesh.nodes[v][axis] *= 0.5;
  const double exact = 3. / 3 * (4 + 2 + 1);
  EXPECT_NEAR(mesh_volume(mesh), exact, exact * rounding);
}

TEST(MeshQuality, WorstCellIsPlaced)
{
  Mesh mesh = quadrilateral({Vector({0, 0, 0}),
                             Vector({1, 0, 0}),
                             Vector({0, 0, 1}),
                             Vector({1, 0, 1})});
  mesh.nodes.push_back(Vector({2, 0, 0.5}));
  mesh.nodes.push_back(Vector({2, 0, 1}));
  mesh.cells.insert(mesh.cells.end(), {1, 4, 3, 5});
  const MeshQuality quality = mesh_quality(mesh);
  EXPECT_NEAR(quality.worst_place[0], 1.5, rounding);
  EXPECT_NEAR(quality.worst_place[2], 0.625, rounding);
  EXPECT_EQ(quality.cells, 2u);
  EXPECT_NE(describe(quality).find("2 cells"), std::string::npos);
  EXPECT_EQ(describe_place(mesh, quality.worst_place),
            "(r, z) = (1500, 625) mm");
}
} // namespace tamp::fem
