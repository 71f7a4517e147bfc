// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/polar.h>
#include <fem/build_mesh.h>
#include <fem/compact.h>
#include <tests/coupling/sample_cells.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <vector>

namespace tamp::coupling
{
namespace
{
using Gradient = dealii::Tensor<2, 3>;
using Vector = dealii::Tensor<1, 3>;

/// Eight hexahedra with not a right angle among them.
fem::Mesh distorted_block()
{
  fem::DieGeometry geometry;
  geometry.shape = fem::DieShape::square;
  geometry.section = fem::Section::quarter;
  geometry.corner_radius = 0;
  geometry.radial_elements = geometry.axial_elements = 2;
  fem::Mesh mesh = fem::build_mesh(geometry);
  EXPECT_EQ(mesh.number_of_cells(), 8u);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    for (unsigned c = 0; c < 3; ++c)
      mesh.nodes[n][c] += 3e-4 * std::sin(7. * double(n) + 2. * c);
  return mesh;
}

/// The node that no face of the block has.
std::size_t inner_node(const fem::Mesh &mesh)
{
  std::vector<unsigned> cells_at(mesh.nodes.size());
  for (const unsigned node : mesh.cells)
    ++cells_at[node];
  return std::size_t(std::ranges::find(cells_at, 8u) - cells_at.begin());
}

/// What takes all nodes from where they are to F x [m].
std::vector<double> linear(const fem::NodePositions &places, const Gradient &F)
{
  std::vector<double> increment;
  for (const Vector &x : places) {
    const Vector u = F * x - x;
    increment.insert(increment.end(), {u[0], u[1], u[2]});
  }
  return increment;
}

Gradient pressed_and_sheared()
{
  Gradient F;
  const double rows[3][3] = {
      {0.999, 0.002, -0.001}, {0.001, 0.998, 0.001}, {-0.002, 0.001, 0.995}};
  for (unsigned a = 0; a < 3; ++a)
    for (unsigned b = 0; b < 3; ++b)
      F[a][b] = rows[a][b];
  return F;
}

Gradient turned()
{
  const double angle = 0.8;
  Gradient Q;
  Q[0][0] = Q[2][2] = std::cos(angle);
  Q[0][2] = -(Q[2][0] = std::sin(angle));
  Q[1][1] = 1;
  return Q;
}

/// A block whose points all start from the same packing.
struct Block {
  fem::Mesh mesh = distorted_block();
  UnitCellPoints cells{test::same_cells(mesh.number_of_points()), test::cold()};
  fem::Compact compact{mesh, cells, fem::Ranks()};

  void deform(const Gradient &F)
  {
    ASSERT_EQ(compact.deform(linear(compact.state().positions, F)).reason, "");
    ASSERT_EQ(compact.evaluate(fem::Want::stress).reason, "");
  }
};

TEST(PatchOfCells, LinearDisplacementGivesEveryPointTheStressOfOneCell)
{
  constexpr double round_off = 1e-12;  // of F, as slips follow it
  constexpr double unbalanced = 1e-10; // round-off of the sums over elements
  Block block;
  UnitCellPoints bare(test::same_cells(1), test::cold());
  const std::size_t inner = inner_node(block.mesh);
  double worst = 0, worst_force = 0;
  for (int step = 0; step < 3; ++step) {
    block.deform(pressed_and_sheared());
    fem::Deformation F;
    F.relative_F = pressed_and_sheared();
    std::vector<fem::Response> wanted(1);
    bare.evaluate(std::span(&F, 1), fem::Want::stress, wanted);
    bare.commit();
    for (const fem::Response &found : block.compact.trial_responses())
      worst = std::max(worst,
                       (found.stress - wanted[0].stress).norm() /
                           wanted[0].stress.norm());
    const std::vector<double> forces = block.compact.internal_forces();
    double largest = 0;
    for (const double force : forces)
      largest = std::max(largest, std::abs(force));
    for (std::size_t c = 0; c < 3; ++c)
      worst_force =
          std::max(worst_force, std::abs(forces[3 * inner + c]) / largest);
    block.compact.accept();
  }
  std::cout << "stresses differ by " << worst
            << " of the stress, the inner node"
            << " is unbalanced by " << worst_force << " of the largest force\n";
  EXPECT_LT(worst, round_off);
  EXPECT_LT(worst_force, unbalanced);
}

TEST(PatchOfCells, ATurnOfTheMeshTurnsForcesAndCostsNoEvaluation)
{
  Block straight, turning;
  const Gradient Q = turned();
  straight.deform(pressed_and_sheared());
  turning.deform(Q * pressed_and_sheared());
  EXPECT_EQ(straight.cells.report().mean_evaluations(),
            turning.cells.report().mean_evaluations());
  const std::vector<double> a = straight.compact.internal_forces(),
                            b = turning.compact.internal_forces();
  double largest = 0;
  for (const double force : a)
    largest = std::max(largest, std::abs(force));
  for (std::size_t n = 0; n < straight.mesh.nodes.size(); ++n) {
    Vector force;
    for (unsigned c = 0; c < 3; ++c)
      force[c] = a[3 * n + c];
    const Vector wanted = Q * force;
    for (unsigned c = 0; c < 3; ++c) // round-off of F, as slips follow it
      EXPECT_NEAR(b[3 * n + c], wanted[c], 1e-12 * largest);
  }
}

TEST(PatchOfCells, MassOfElementsIsThatOfTheirCells)
{
  // Of every point in every step, on elements that all deform differently.
  Block block;
  std::vector<double> start;
  for (std::size_t i = 0; i < block.cells.size(); ++i)
    start.push_back(block.cells.cell(i).relative_density() *
                    block.compact.geometry()[i].volume);
  for (int step = 0; step < 3; ++step) {
    std::vector<double> increment;
    for (const Vector &x : block.compact.state().positions)
      increment.insert(increment.end(),
                       {3e-3 * x[2] * std::sin(500 * x[2]),
                        2e-3 * x[0] * std::cos(300 * x[1]),
                        -8e-3 * x[2] * (1 + 100 * x[0])});
    ASSERT_EQ(block.compact.deform(increment).reason, "");
    ASSERT_EQ(block.compact.evaluate(fem::Want::stress).reason, "");
    block.compact.accept();
    for (std::size_t i = 0; i < block.cells.size(); ++i) {
      const double mass = block.cells.cell(i).relative_density() *
                          block.compact.geometry()[i].volume;
      const double volume =
          dealii::determinant(block.compact.state().deformation_gradients[i]);
      const dem::UnitCell &cell = block.cells.cell(i);
      EXPECT_NEAR(mass / start[i], 1, 1e-12); // round-off
      EXPECT_NEAR(cell.box.volume() /
                      (test::sample_cell().box.volume() * volume),
                  1,
                  1e-12);
    }
  }
}
} // namespace
} // namespace tamp::coupling
