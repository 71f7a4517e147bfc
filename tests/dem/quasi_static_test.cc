// SPDX-License-Identifier: BSD-3-Clause
#include <dem/deform.h>
#include <dem/measures.h>
#include <dem/stretch.h>
#include <tests/dem/sample_cells.h>

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
using test::alumina_cell;
using test::compress;
using test::message_of;
using test::uniaxial;

/// The packing at 1 % strain, where it is well jammed.
const UnitCell &jammed_cell()
{
  static const UnitCell cell = [] {
    UnitCell result = alumina_cell();
    compress(result, -0.01, 4, {});
    return result;
  }();
  return cell;
}

Stretch oblique_stretch(double size)
{
  Matrix3 strain;
  strain << -1, .4, .1, .4, -.3, -.2, .1, -.2, .2;
  return exponential(size * strain);
}

Driving tight(double tolerance)
{
  Driving driving;
  driving.quasi_static.unbalance_tolerance = tolerance;
  driving.quasi_static.maximum_evaluations = 50000;
  return driving;
}

double difference(const Matrix3 &a, const Matrix3 &b)
{
  return (a - b).norm() / b.norm();
}

TEST(QuasiStatic, SameCellAndStretchGiveTheSameBits)
{
  UnitCell a = jammed_cell(), b = jammed_cell();
  const CellAnswer one = deform(a, oblique_stretch(3e-3), {});
  const CellAnswer two = deform(b, oblique_stretch(3e-3), {});
  EXPECT_EQ(one.outcome, Outcome::settled);
  EXPECT_EQ(one.stress, two.stress);
  EXPECT_EQ(one.evaluations, two.evaluations);
  EXPECT_EQ(a, b);
}

TEST(QuasiStatic, BoxIsExactlyStretched)
{
  for (double size : {1e-3, 4e-2}) { // in one part, and in several
    UnitCell cell = jammed_cell();
    const Stretch stretch = oblique_stretch(size);
    const Matrix3 wanted = stretch * cell.box.h;
    deform(cell, stretch, {});
    EXPECT_LT((cell.box.h - wanted).norm(), 1e-14 * wanted.norm());
    EXPECT_NEAR(cell.box.volume() / wanted.determinant(), 1, 1e-14);
  }
}

TEST(QuasiStatic, StressIsThatOfTheCellItLeaves)
{
  UnitCell cell = jammed_cell();
  const CellAnswer answer = deform(cell, uniaxial(-2e-3), {});
  EXPECT_EQ(answer.stress, love_weber_stress(cell));
}

TEST(QuasiStatic, TwoHalvesAreNearlyTheWhole)
{
  UnitCell whole = jammed_cell(), halves = jammed_cell();
  const CellAnswer one = compress(whole, -5e-3, 1, {});
  const CellAnswer two = compress(halves, -5e-3, 2, {});
  EXPECT_EQ(one.outcome, Outcome::settled);
  EXPECT_LT(difference(one.stress, two.stress), 0.005); // roughness of the map
}

TEST(QuasiStatic, SmallElasticCycleReturns)
{
  // Smooth elastic grains have no memory: stress is a function of the box.
  UnitCell cell = test::smooth_elastic_cell();
  const Driving driving = tight(1e-7);
  const Stretch stretch = oblique_stretch(1e-5);
  const CellAnswer before = compress(cell, -5e-3, 2, driving);
  const CellAnswer there = deform(cell, stretch, driving);
  const CellAnswer back = deform(cell, stretch.inverse(), driving);
  ASSERT_EQ(back.outcome, Outcome::settled);
  const double travelled = (there.stress - before.stress).norm();
  EXPECT_GT(travelled, 1e-4 * before.stress.norm());
  // The unbalance, over the relative change of stress of about 1e-3.
  EXPECT_LT((back.stress - before.stress).norm(), 1e-3 * travelled);
}

TEST(QuasiStatic, WorkIsStoredOrDissipated)
{
  UnitCell cell = alumina_cell();
  const double stored = measure(cell).elastic_energy;
  const CellAnswer answer = compress(cell, std::log(0.9), 50, {});
  EXPECT_EQ(answer.outcome, Outcome::settled);
  const EnergyAccount &spent = cell.energy;
  const double gained = measure(cell).elastic_energy - stored;
  EXPECT_GT(spent.plastic_dissipation, 0);
  EXPECT_GT(spent.friction_dissipation, 0);
  EXPECT_EQ(spent.damping_dissipation, 0);
  EXPECT_NEAR(gained + spent.plastic_dissipation + spent.friction_dissipation,
              spent.work,
              0.01 * spent.work); // trapezoids of the work, unbalance
}

TEST(QuasiStatic, EquilibriumKeepsWorkAndMomentOfMomentum)
{
  for (double tolerance : {1e-3, 1e-5}) {
    UnitCell cell = jammed_cell();
    const CellAnswer answer = compress(cell, -2e-3, 1, tight(tolerance));
    EXPECT_EQ(answer.outcome, Outcome::settled);
    EXPECT_LE(answer.unbalance, tolerance);
    EXPECT_LT(answer.hill_mandel, tolerance);
    EXPECT_LT(measure(cell).asymmetry, tolerance);
  }
}

TEST(QuasiStatic, WorkResidualIsSmallWhereNextToNothingIsStrained)
{
  // The cell follows with forces that are far from its own balance, as where a
  // compact that has been let go slides: the grains keep what moved them in a
  // larger trial.
  const UnitCell committed = jammed_cell();
  Driving driving = tight(1e-3);
  driving.quasi_static.force_floor = 100 * measure(committed).mean_normal_force;
  WarmGuess guess;
  UnitCell larger = committed, cell = committed;
  deform(larger, uniaxial(-1e-4), driving, &guess);
  const CellAnswer answer = deform(cell, uniaxial(-1e-6), driving, &guess);
  EXPECT_EQ(answer.outcome, Outcome::settled);
  EXPECT_LT(answer.hill_mandel, 1e-3); // the unbalance that is left
}

TEST(QuasiStatic, WarmGuessGivesTheSameStressSooner)
{
  const UnitCell committed = jammed_cell();
  WarmGuess guess;
  UnitCell first = committed;
  deform(first, uniaxial(-2e-3), {}, &guess);
  ASSERT_FALSE(guess.empty());
  UnitCell warm = committed, cold = committed;
  const CellAnswer fast = deform(warm, uniaxial(-2.05e-3), {}, &guess);
  const CellAnswer slow = deform(cold, uniaxial(-2.05e-3), {});
  EXPECT_EQ(fast.outcome, Outcome::settled);
  EXPECT_LT(fast.evaluations, slow.evaluations);
  EXPECT_LT(difference(fast.stress, slow.stress), 0.005); // as above
}

TEST(QuasiStatic, EmptyGuessIsNoGuess)
{
  UnitCell with = jammed_cell(), without = jammed_cell();
  WarmGuess guess;
  const CellAnswer a = deform(with, uniaxial(-2e-3), {}, &guess);
  const CellAnswer b = deform(without, uniaxial(-2e-3), {});
  EXPECT_EQ(a.stress, b.stress);
  EXPECT_EQ(with, without);
}

TEST(QuasiStatic, ClearedGuessIsNoGuess)
{
  UnitCell with = jammed_cell();
  WarmGuess guess;
  deform(with, uniaxial(-2e-3), {}, &guess);
  UnitCell without = with;
  guess.clear();
  deform(with, uniaxial(-2e-3), {}, &guess);
  deform(without, uniaxial(-2e-3), {});
  EXPECT_EQ(with, without); // the work that was done, too
}

TEST(QuasiStatic, TrialsWithAGuessBookTheWorkOfTrialsWithout)
{
  const UnitCell committed = jammed_cell();
  WarmGuess guess;
  UnitCell first = committed, warm = committed, cold = committed;
  deform(first, uniaxial(-2e-3), {}, &guess);
  deform(warm, uniaxial(-1e-3), {}, &guess);
  deform(cold, uniaxial(-1e-3), {});
  const double work = cold.energy.work - committed.energy.work;
  EXPECT_NEAR(warm.energy.work - committed.energy.work,
              work,
              0.005 * work); // stresses are as near, see above
}

TEST(QuasiStatic, CellThatDoesNotSettleSaysSoAndKeepsNoGuess)
{
  UnitCell cell = jammed_cell();
  WarmGuess guess;
  deform(cell, uniaxial(-2e-3), {}, &guess);
  ASSERT_FALSE(guess.empty());
  cell = jammed_cell();
  Driving driving;
  driving.quasi_static.maximum_evaluations = 5;
  const CellAnswer answer = deform(cell, uniaxial(-5e-3), driving, &guess);
  EXPECT_EQ(answer.outcome, Outcome::unsettled);
  EXPECT_EQ(answer.evaluations, 5u);
  EXPECT_GT(answer.unbalance, driving.quasi_static.unbalance_tolerance);
  EXPECT_TRUE(guess.empty());
}

TEST(QuasiStatic, OnePartThatDoesNotSettleIsNotForgotten)
{
  UnitCell cell = alumina_cell();
  Driving driving;
  driving.quasi_static.maximum_evaluations = 60;
  const CellAnswer answer = deform(cell, uniaxial(-0.04), driving);
  EXPECT_EQ(answer.outcome, Outcome::unsettled);
}

TEST(QuasiStatic, WildStretchDivergesAndLeavesCopiesAlone)
{
  const UnitCell committed = jammed_cell();
  UnitCell trial = committed;
  Driving driving;
  driving.quasi_static.maximum_strain_increment = 1;
  WarmGuess guess;
  EXPECT_EQ(deform(trial, uniaxial(std::log(0.49)), driving, &guess).outcome,
            Outcome::diverged);
  EXPECT_TRUE(guess.empty());
  EXPECT_EQ(committed, jammed_cell());
  trial = committed;
  EXPECT_EQ(deform(trial, uniaxial(-1e-3), {}).outcome, Outcome::settled);
}

TEST(QuasiStatic, AgreesWithSlowDynamicsFromLooseToDense)
{
  // The cell starts at 0.5 MPa; 30 % of its height is a strain of 0.357.
  UnitCell fine = alumina_cell(), coarse = alumina_cell(),
           slow = alumina_cell();
  Driving driving;
  driving.method = Method::dynamics;
  driving.dynamics.strain_rate = 5e-5;
  const double part = -0.357 / 4;
  for (int k = 0; k < 4; ++k) {
    const CellAnswer reference = compress(slow, part, 1, driving);
    for (UnitCell *cell : {&fine, &coarse}) {
      const CellAnswer map = compress(*cell, part, cell == &fine ? 90 : 18, {});
      // Rearrangements that come sooner or later, and what is left of the rate.
      EXPECT_LT(difference(map.stress, reference.stress), 0.02);
    }
  }
}

TEST(QuasiStatic, AgreesWithSlowDynamics)
{
  UnitCell quick = alumina_cell(), slow = alumina_cell();
  const CellAnswer map = compress(quick, -0.05, 25, {});
  Driving driving;
  driving.method = Method::dynamics;
  driving.dynamics.strain_rate = 2e-5;
  const CellAnswer reference = compress(slow, -0.05, 5, driving);
  // Rearrangements that come sooner or later, unbalance of both.
  EXPECT_LT(difference(map.stress, reference.stress), 0.01);
}

TEST(Driving, RefusalsNameTheValue)
{
  const auto refusal = [](const Driving &driving) {
    return message_of<std::invalid_argument>([&] { driving.check(); });
  };
  EXPECT_EQ(refusal({}), "");
  Driving driving;
  driving.quasi_static.unbalance_tolerance = 0;
  EXPECT_NE(refusal(driving).find("unbalance tolerance = 0"),
            std::string::npos);
  driving = {};
  driving.quasi_static.maximum_strain_increment = -1;
  EXPECT_NE(refusal(driving).find("maximum strain increment = -1"),
            std::string::npos);
  driving = {};
  driving.dynamics.time_step_fraction = 2;
  EXPECT_NE(refusal(driving).find("time step fraction = 2"), std::string::npos);
  driving = {};
  driving.dynamics.global_damping = -0.5;
  EXPECT_NE(refusal(driving).find("global damping = -0.5"), std::string::npos);
  driving = {};
  driving.dynamics.local_damping = 1;
  EXPECT_NE(refusal(driving).find("local damping = 1"), std::string::npos);
}
} // namespace
} // namespace tamp::dem
