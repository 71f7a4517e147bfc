// SPDX-License-Identifier: BSD-3-Clause
#include <fem/assembler.h>
#include <tests/fem/test_points.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace tamp::fem
{
namespace
{
using test::HenckyLaw;
using test::HenckyPoints;

DieMesh make_mesh(unsigned radial, unsigned axial)
{
  DieGeometry geometry;
  geometry.radial_elements = radial;
  geometry.axial_elements = axial;
  return DieMesh(geometry);
}

std::set<unsigned> boundary(const DieMesh::Data &mesh)
{
  std::set<unsigned> nodes;
  for (const auto *side :
       {&mesh.axis, &mesh.wall, &mesh.punch_bottom, &mesh.punch_top})
    nodes.insert(side->begin(), side->end());
  return nodes;
}

/// The same mesh with its inner nodes moved out of order.
DieMesh::Data distorted(DieMesh::Data mesh)
{
  const auto held = boundary(mesh);
  for (unsigned n = 0; n < mesh.nodes.size(); ++n)
    if (held.count(n) == 0) {
      mesh.nodes[n][0] += 3e-4 * std::sin(7. * n);
      mesh.nodes[n][1] += 2e-4 * std::cos(5. * n);
    }
  return mesh;
}

struct Evaluation {
  std::vector<Response> responses;
  std::vector<double> force;
};

Evaluation evaluate(const DieMesh::Data &mesh,
                    HenckyPoints &points,
                    const Displacement &increment,
                    Want want)
{
  std::vector<Deformation> deformations;
  relative_deformations(mesh, mesh.nodes, increment, deformations);
  Evaluation result;
  result.responses.resize(points.size());
  points.evaluate(deformations, want, result.responses);
  result.force = internal_forces(
      mesh, moved(mesh.nodes, increment), result.responses);
  return result;
}

double largest(const std::vector<double> &values)
{
  double result = 0;
  for (const double value : values)
    result = std::max(result, std::abs(value));
  return result;
}
} // namespace

TEST(Assembler, UniformStrainGivesUniformStressAndBalance)
{
  const DieMesh regular = make_mesh(4, 5);
  const DieMesh::Data mesh = distorted(regular.data());
  HenckyPoints points(mesh.number_of_points(), HenckyLaw());
  Displacement increment(mesh.number_of_dofs());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    increment[2 * n] = 0.02 * mesh.nodes[n][0];
    increment[2 * n + 1] = -0.05 * mesh.nodes[n][1];
  }
  const Evaluation now = evaluate(mesh, points, increment, Want::stress);
  dealii::Tensor<2, 3> F;
  F[0][0] = F[1][1] = 1.02;
  F[2][2] = 0.95;
  const auto expected = HenckyLaw().stress(F);
  for (const Response &response : now.responses)
    EXPECT_LT((response.stress - expected).norm(), 1e-12 * expected.norm());
  const auto held = boundary(mesh);
  for (unsigned n = 0; n < mesh.nodes.size(); ++n)
    for (unsigned c = 0; c < 2; ++c)
      if (held.count(n) == 0) {
        EXPECT_LT(std::abs(now.force[2 * n + c]), 1e-10 * largest(now.force));
      }
}

TEST(Assembler, PunchForceIsStressTimesArea)
{
  const DieMesh mesh = make_mesh(3, 2);
  HenckyPoints points(mesh.number_of_points(), HenckyLaw());
  Displacement increment(mesh.data().number_of_dofs(), 0.);
  for (std::size_t n = 0; n < mesh.data().nodes.size(); ++n)
    increment[2 * n + 1] = -0.1 * mesh.data().nodes[n][1];
  const Evaluation now = evaluate(mesh.data(), points, increment, Want::stress);
  double force = 0;
  for (const unsigned n : mesh.data().punch_top)
    force += now.force[2 * n + 1];
  const double area = std::numbers::pi * mesh.radius() * mesh.radius();
  EXPECT_NEAR(force / (now.responses[0].stress[2][2] * area), 1, 1e-12);
}

TEST(Assembler, StiffnessAgreesWithDifferencesOfTheForces)
{
  const DieMesh regular = make_mesh(3, 3);
  const DieMesh::Data mesh = distorted(regular.data());
  HenckyLaw law;
  law.stiffening = 4;
  HenckyPoints points(mesh.number_of_points(), law);
  Displacement increment(mesh.number_of_dofs());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const auto &x = mesh.nodes[n];
    increment[2 * n] = x[0] * (0.05 * std::sin(600 * x[1]) + 0.03);
    increment[2 * n + 1] = -0.15 * x[1] + 0.1 * x[0];
  }
  const Evaluation now =
      evaluate(mesh, points, increment, Want::stress_and_tangent);
  SparseRows stiffness = stiffness_pattern(mesh);
  assemble_stiffness(
      mesh, moved(mesh.nodes, increment), now.responses, stiffness);
  // Central differences of a smooth function: error about (1e-4)^2.
  const double d = 1e-8;
  for (std::size_t dof = 0; dof < increment.size(); dof += 3) {
    Displacement plus = increment, minus = increment, unit(increment.size());
    plus[dof] += d;
    minus[dof] -= d;
    unit[dof] = 1;
    const auto column = multiply(stiffness, unit);
    const auto above = evaluate(mesh, points, plus, Want::stress).force;
    const auto below = evaluate(mesh, points, minus, Want::stress).force;
    for (std::size_t row = 0; row < increment.size(); ++row)
      EXPECT_NEAR(column[row],
                  (above[row] - below[row]) / (2 * d),
                  1e-6 * largest(column));
  }
}
} // namespace tamp::fem
