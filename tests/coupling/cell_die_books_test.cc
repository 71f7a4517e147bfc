// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
#include <tests/coupling/cell_bench.h>
#include <tests/coupling/sample_cells.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <numbers>

namespace tamp::coupling
{
namespace
{
using test::CellBench;

/// A die whose wall rubs.
fem::DieSettings rubbing_die(unsigned radial, unsigned axial)
{
  fem::DieSettings settings;
  settings.geometry.radial_elements = radial;
  settings.geometry.axial_elements = axial;
  settings.friction[fem::die_wall] = fem::FrictionCoefficient(0.2);
  return settings;
}

/// Work that has been done [J]: mean force of a step times its way, summed.
struct Work {
  double punches = 0;  ///< by the punches on the powder
  double friction = 0; ///< by the powder against friction
  double cells = 0;    ///< by the stress of the cells, each in its volume
};

/// Where the nodes and the punch stand, and what pushes there.
struct Place {
  fem::NodePositions nodes;
  std::vector<fem::PairForce> forces;
  double punch = 0, punch_force = 0;

  explicit Place(const fem::Press &press)
      : nodes(press.compact().state().positions),
        forces(press.contact().accepted()),
        punch(press.tools()[fem::upper_punch]),
        punch_force(press.forces()[fem::upper_punch].force[2])
  {
  }
};

/// Powder that moves against friction of any tool loses this [J].
double work_against_friction(const fem::Press &press,
                             const Place &from,
                             const Place &to)
{
  double work = 0;
  for (std::size_t i = 0; i < to.forces.size(); ++i) {
    const unsigned node = press.contact().pairs()[i].node;
    const auto moved = to.nodes[node] - from.nodes[node];
    work -= 0.5 * (from.forces[i].friction + to.forces[i].friction) * moved;
  }
  return work;
}

/// Work of the stress of all cells so far, each as often as its volume is in
/// that of its material point [J].
double work_of_cells(const CellBench &bench)
{
  double work = 0;
  for (std::size_t i = 0; i < bench.cells.size(); ++i) {
    const dem::UnitCell &cell = bench.cells.cell(i);
    work += cell.energy.work * bench.press.compact().geometry()[i].volume /
            cell.box.volume();
  }
  return work;
}

TEST(CellDieBooks, WorkOfThePunchIsThatOfTheCellsAndOfWallFriction)
{
  // Hill and Mandel for the whole die. Force and stress are taken as linear
  // over a step both times, so what is left is the unbalance of the die, 1e-4
  // here, that stresses act on strains of other places, and its second order.
  constexpr double unbalance = 1e-3;
  fem::DieSettings settings = rubbing_die(1, 2);
  settings.solver.force_tolerance = 1e-4;
  CellBench bench(settings, test::different_cells(8), {});
  bench.press_by(1e-8); // the stress that the packings bring is balanced
  const double before = work_of_cells(bench);
  const fem::WorkAccount start = bench.press.work();
  Work work;
  for (int step = 0; step < 25; ++step) {
    const Place from(bench.press);
    bench.press_by(20e-6);
    const Place to(bench.press);
    work.punches +=
        0.5 * (from.punch_force + to.punch_force) * (to.punch - from.punch);
    work.friction += work_against_friction(bench.press, from, to);
    work.cells = work_of_cells(bench) - before;
    EXPECT_NEAR(
        work.cells + work.friction, work.punches, unbalance * work.punches);
  }
  EXPECT_GT(work.friction, 0.01 * work.punches);
  // The books of the die itself say the same.
  const fem::WorkAccount &booked = bench.press.work();
  EXPECT_LT(booked.residual(), unbalance);
  EXPECT_NEAR(booked.tools - start.tools, work.punches, 1e-12 * work.punches);
  EXPECT_NEAR(booked.lost - start.lost, work.friction, 1e-6 * work.friction);
  EXPECT_NEAR(booked.powder - start.powder, work.cells, unbalance * work.cells);
  std::cout << "work of the punch " << work.punches << " J, of the cells "
            << work.cells << " J, of friction " << work.friction
            << " J, left over "
            << (work.cells + work.friction) / work.punches - 1 << "\n";
}

TEST(CellDieBooks, MassStaysInEveryStep)
{
  const fem::DieSettings settings = rubbing_die(2, 2);
  CellBench bench(settings, test::different_cells(16), {});
  const auto mass = [&bench] {
    double result = 0;
    for (std::size_t i = 0; i < bench.cells.size(); ++i)
      result += bench.cells.cell(i).relative_density() *
                bench.press.compact().geometry()[i].volume;
    return result;
  };
  const double start = mass();
  for (int step = 0; step < 5; ++step) {
    bench.press_by(30e-6);
    EXPECT_NEAR(mass() / start, 1, 1e-12); // round-off
  }
}

TEST(CellDieBooks, CellsUnderAPunchWithoutFrictionAddUpToItsForce)
{
  // In one element every cell is pressed alike, so that the pressure of the
  // punch is the mean of the curves of bare cells; theirs scatter.
  const fem::DieSettings settings = [] {
    fem::DieSettings result = rubbing_die(1, 1);
    result.friction[fem::die_wall] = fem::FrictionCoefficient(0);
    return result;
  }();
  CellBench bench(settings, test::different_cells(4), test::cold());
  UnitCellPoints bare(test::different_cells(4), test::cold());
  double height = settings.geometry.fill_height;
  for (int step = 0; step < 10; ++step) {
    const double distance = 30e-6;
    bench.press_by(distance);
    fem::Deformation F;
    F.relative_F[0][0] = F.relative_F[1][1] = 1;
    F.relative_F[2][2] = 1 - distance / height;
    height -= distance;
    std::vector<fem::Response> curves(4);
    bare.evaluate(
        std::vector<fem::Deformation>(4, F), fem::Want::stress, curves);
    bare.commit();
    double wanted = 0, least = 0, most = -1e300;
    for (std::size_t i = 0; i < 4; ++i) {
      const double stress = curves[i].stress[2][2];
      wanted += stress * bench.press.compact().geometry()[i].volume / height;
      least = std::min(least, stress);
      most = std::max(most, stress);
    }
    const double found = bench.press.forces()[fem::upper_punch].force[2];
    EXPECT_NEAR(found / wanted, 1, 1e-10); // round-off of F, as slips follow it
    EXPECT_GT(std::abs(most - least), 0.02 * std::abs(least));
  }
}

TEST(CellDieBooks, EveryUpdateOfTheCellsMoreThanHalvesTheResidual)
{
  // All attempts start from the same state; they differ in where they stop.
  fem::DieSettings settings = rubbing_die(2, 4);
  CellBench bench(settings, test::different_cells(32), test::cold());
  for (const double distance : {7e-6, 9e-6, 12e-6, 15e-6, 18e-6, 23e-6, 28e-6})
    bench.press_by(distance);
  std::vector<double> residuals;
  settings.solver.force_tolerance = 1e-300;
  for (unsigned updates = 1; updates <= 5; ++updates) {
    settings.solver.maximum_iterations = updates;
    fem::Equilibrium strict(bench.press, settings.solver, 0.2);
    const fem::Attempt attempt = bench.attempt(35e-6, strict);
    EXPECT_EQ(attempt.iterations, updates);
    residuals.push_back(attempt.force_residual);
  }
  const double factor = std::pow(residuals.back() / residuals.front(), 1. / 4);
  std::cout << "force residuals";
  for (const double residual : residuals)
    std::cout << " " << residual;
  std::cout << ", factor per update " << factor << "\n";
  EXPECT_GT(residuals.front(), 1e-3); // there was something to do
  EXPECT_LT(factor, 0.5);
}
} // namespace
} // namespace tamp::coupling
