// SPDX-License-Identifier: BSD-3-Clause
#include <fem/build_mesh.h>
#include <fem/compact.h>
#include <tests/fem/test_points.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

namespace tamp::fem
{
namespace
{
using test::HenckyLaw;
using test::HenckyPoints;

Mesh rectangle(unsigned radial, unsigned axial)
{
  DieGeometry geometry;
  geometry.radial_elements = radial;
  geometry.axial_elements = axial;
  return build_mesh(geometry);
}

Mesh block(unsigned side, unsigned axial)
{
  DieGeometry geometry;
  geometry.shape = DieShape::square;
  geometry.section = Section::quarter;
  geometry.corner_radius = 0;
  geometry.radial_elements = side;
  geometry.axial_elements = axial;
  return build_mesh(geometry);
}

std::set<unsigned> boundary(const Mesh &mesh)
{
  std::set<unsigned> nodes;
  for (const auto &tool : mesh.tools)
    nodes.insert(tool.nodes.begin(), tool.nodes.end());
  for (const auto &held : mesh.held)
    nodes.insert(held.node);
  return nodes;
}

/// The same mesh with its inner nodes moved out of order.
Mesh distorted(Mesh mesh)
{
  const auto held = boundary(mesh);
  for (unsigned n = 0; n < mesh.nodes.size(); ++n)
    if (held.count(n) == 0)
      for (unsigned c = 0; c < mesh.components(); ++c)
        mesh.nodes[n][mesh.axis(c)] += 3e-4 * std::sin(7. * n + 2. * c);
  return mesh;
}

double largest(const std::vector<double> &values)
{
  double result = 0;
  for (const double value : values)
    result = std::max(result, std::abs(value));
  return result;
}

/// Displacement of all degrees of freedom from one of places.
template <class Field>
std::vector<double> displacement(const Mesh &mesh, const Field &field)
{
  std::vector<double> result(mesh.number_of_dofs());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const dealii::Tensor<1, 3> u = field(mesh.nodes[n]);
    for (unsigned c = 0; c < mesh.components(); ++c)
      result[mesh.dof(n, c)] = u[mesh.axis(c)];
  }
  return result;
}

dealii::Tensor<1, 3> vector(double x, double y, double z)
{
  dealii::Tensor<1, 3> result;
  result[0] = x;
  result[1] = y;
  result[2] = z;
  return result;
}

/// A body of Hencky points after one displacement.
struct Body {
  HenckyPoints points;
  Compact compact;

  Body(const Mesh &mesh,
       const std::vector<double> &increment,
       const HenckyLaw &law = {},
       bool f_bar = false)
      : points(mesh.number_of_points(), law),
        compact(mesh, points, Ranks(), f_bar)
  {
    EXPECT_EQ(compact.deform(increment).reason, "");
    EXPECT_EQ(compact.evaluate(Want::stress_and_tangent).reason, "");
  }
};

void expect_patch(const Mesh &mesh, const dealii::Tensor<2, 3> &F, bool f_bar)
{
  const auto increment =
      displacement(mesh, [&](const auto &x) { return F * x - x; });
  const Body body(mesh, increment, {}, f_bar);
  const auto expected = HenckyLaw().stress(F);
  // Round-off of sums over a cell.
  for (const Response &response : body.compact.trial_responses())
    EXPECT_LT((response.stress - expected).norm(), 1e-12 * expected.norm());
  const auto force = body.compact.internal_forces();
  const auto held = boundary(mesh);
  for (unsigned n = 0; n < mesh.nodes.size(); ++n)
    for (unsigned c = 0; c < mesh.components(); ++c)
      if (held.count(n) == 0) {
        EXPECT_LT(std::abs(force[mesh.dof(n, c)]), 1e-12 * largest(force));
      }
}

void expect_consistent(const Mesh &mesh, bool f_bar)
{
  HenckyLaw law;
  law.stiffening = 4;
  const auto increment = displacement(mesh, [](const auto &x) {
    return vector(x[0] * (0.05 * std::sin(600 * x[2]) + 0.03),
                  0.04 * x[1] - 0.05 * x[2],
                  -0.15 * x[2] + 0.1 * x[0]);
  });
  const Body body(mesh, increment, law, f_bar);
  SparseRows stiffness = body.compact.assembler().pattern();
  body.compact.assemble_stiffness(stiffness);
  // Central differences of a smooth function: error about (1e-4)^2.
  const double d = 1e-8;
  for (std::size_t dof = 0; dof < increment.size(); dof += 7) {
    std::vector<double> plus = increment, minus = increment,
                        unit(increment.size());
    plus[dof] += d;
    minus[dof] -= d;
    unit[dof] = 1;
    const auto column = multiply(stiffness, unit);
    const auto above = Body(mesh, plus, law, f_bar).compact.internal_forces();
    const auto below = Body(mesh, minus, law, f_bar).compact.internal_forces();
    for (std::size_t row = 0; row < increment.size(); ++row)
      EXPECT_NEAR(column[row],
                  (above[row] - below[row]) / (2 * d),
                  1e-6 * largest(column));
  }
}
} // namespace

TEST(Assembler, PatchOfDistortedQuadrilateralsIsExact)
{
  dealii::Tensor<2, 3> F;
  F[0][0] = F[1][1] = 1.02;
  F[2][2] = 0.95;
  for (const bool f_bar : {false, true})
    expect_patch(distorted(rectangle(4, 5)), F, f_bar);
}

TEST(Assembler, PatchOfDistortedHexahedraIsExact)
{
  dealii::Tensor<2, 3> F;
  F[0] = vector(1.02, 0.03, -0.01);
  F[1] = vector(0.01, 0.97, 0.02);
  F[2] = vector(-0.04, 0.02, 0.93);
  for (const bool f_bar : {false, true})
    expect_patch(distorted(block(3, 4)), F, f_bar);
}

TEST(Assembler, RotationTurnsForcesAndAddsNone)
{
  const Mesh mesh = distorted(block(2, 2));
  dealii::Tensor<2, 3> stretch, rotation;
  stretch[0][0] = 1.01;
  stretch[1][1] = 0.99;
  stretch[2][2] = 0.9;
  const double angle = 0.7;
  rotation[0] = vector(std::cos(angle), 0, std::sin(angle));
  rotation[1] = vector(0, 1, 0);
  rotation[2] = vector(-std::sin(angle), 0, std::cos(angle));
  const Body still(
      mesh, displacement(mesh, [&](const auto &x) { return stretch * x - x; }));
  const Body turned(mesh, displacement(mesh, [&](const auto &x) {
                      return rotation * stretch * x - x;
                    }));
  const auto a = still.compact.internal_forces();
  const auto b = turned.compact.internal_forces();
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const auto expected =
        rotation * vector(a[3 * n], a[3 * n + 1], a[3 * n + 2]);
    for (unsigned c = 0; c < 3; ++c)
      EXPECT_NEAR(b[3 * n + c], expected[c], 1e-12 * largest(a)); // round-off
  }
}

TEST(Assembler, PunchForceIsStressTimesArea)
{
  const Mesh mesh = rectangle(3, 2);
  const Body body(mesh, displacement(mesh, [](const auto &x) {
                    return vector(0, 0, -0.1 * x[2]);
                  }));
  const auto forces = body.compact.internal_forces();
  double force = 0;
  for (const unsigned n : mesh.tools[upper_punch].nodes)
    force += forces[mesh.axial_dof(n)];
  const double area = std::numbers::pi * 6e-3 * 6e-3;
  const double stress = body.compact.trial_responses()[0].stress[2][2];
  EXPECT_NEAR(force / (stress * area), 1, 1e-12);
}

TEST(Assembler, StiffnessAgreesWithDifferencesOfTheForces)
{
  expect_consistent(distorted(rectangle(3, 3)), false);
  expect_consistent(distorted(block(2, 2)), false);
}

TEST(Assembler, StiffnessOfFBarAgreesWithDifferencesOfTheForces)
{
  expect_consistent(distorted(rectangle(3, 3)), true);
  expect_consistent(distorted(block(2, 2)), true);
}

TEST(Assembler, SharesOfTheCellsAddUp)
{
  const Mesh mesh = block(2, 3);
  const Assembler all(mesh, {0, mesh.number_of_cells()});
  const Assembler low(mesh, {0, 5}), high(mesh, {5, mesh.number_of_cells()});
  EXPECT_EQ(low.pattern().size(), all.pattern().size());
  EXPECT_GT(low.pattern().value.size() + high.pattern().value.size(),
            all.pattern().value.size()); // the rows between are in both
}
} // namespace tamp::fem
