// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/polar.h>
#include <dem/measures.h>
#include <dem/random_numbers.h>
#include <tests/coupling/sample_cells.h>
#include <tests/dem/sample_cells.h>

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <numbers>
#include <stdexcept>

namespace tamp::coupling
{
namespace
{
using fem::Deformation;
using fem::Response;
using fem::Want;
using test::pressed;

std::vector<Response> evaluate(UnitCellPoints &points, const Deformation &F)
{
  std::vector<Response> responses(points.size());
  points.evaluate(std::vector<Deformation>(points.size(), F),
                  Want::stress_and_tangent,
                  responses);
  return responses;
}

std::vector<char> bytes_of(const UnitCellPoints &points)
{
  std::vector<char> bytes;
  for (std::size_t i = 0; i < points.size(); ++i)
    points.pack(i, bytes);
  return bytes;
}

TEST(UnitCellPoints, AnswersDoNotDependOnThreads)
{
  CellPointsOptions one, three;
  three.threads = 3;
  UnitCellPoints a(test::different_cells(8), one);
  UnitCellPoints b(test::different_cells(8), three);
  for (int step = 0; step < 3; ++step) {
    for (double strain : {4e-3, 5e-3}) { // the second one starts warm
      const auto x = evaluate(a, pressed(strain));
      const auto y = evaluate(b, pressed(strain));
      for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_EQ(x[i].stress, y[i].stress);
        EXPECT_EQ(x[i].tangent, y[i].tangent);
      }
    }
    a.commit();
    b.commit();
  }
  EXPECT_EQ(bytes_of(a), bytes_of(b));
}

TEST(UnitCellPoints, AnAbandonedAttemptLeavesNoTrace)
{
  UnitCellPoints tried(test::different_cells(4), {}),
      straight(test::different_cells(4), {});
  for (UnitCellPoints *points : {&tried, &straight}) {
    points->begin_attempt();
    evaluate(*points, pressed(5e-3));
    points->commit();
  }
  const std::vector<char> committed = bytes_of(tried);
  tried.begin_attempt();
  evaluate(tried, pressed(2e-2));
  evaluate(tried, pressed(1.9e-2));
  EXPECT_EQ(bytes_of(tried), committed);
  for (UnitCellPoints *points : {&tried, &straight})
    points->begin_attempt();
  for (double strain : {5e-3, 4.9e-3}) {
    const auto x = evaluate(tried, pressed(strain));
    const auto y = evaluate(straight, pressed(strain));
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_EQ(x[i].stress, y[i].stress);
  }
  tried.commit();
  straight.commit();
  EXPECT_EQ(bytes_of(tried), bytes_of(straight));
}

TEST(UnitCellPoints, RotationCostsNoSweep)
{
  UnitCellPoints points(test::same_cells(1), test::cold());
  evaluate(points, pressed(5e-3));
  points.commit();
  const double angle = 1.3;
  Deformation turn;
  turn.relative_F[0][0] = turn.relative_F[2][2] = std::cos(angle);
  turn.relative_F[0][2] = -(turn.relative_F[2][0] = std::sin(angle));
  turn.relative_F[1][1] = 1;
  evaluate(points, turn);
  EXPECT_EQ(points.report().mean_evaluations(), 1);
}

TEST(UnitCellPoints, RotatedPathRotatesStress)
{
  // Each increment and a large rotation of its own, step by step.
  UnitCellPoints straight(test::same_cells(1), test::cold()),
      turning(test::same_cells(1), test::cold());
  dem::RandomNumbers random(11);
  dem::Matrix3 Q = dem::Matrix3::Identity();
  for (int step = 0; step < 6; ++step) {
    dem::Matrix3 any;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        any(a, b) = 2 * random.next() - 1;
    dem::Matrix3 F = dem::Matrix3::Identity() + 1e-3 * any;
    F(2, 2) -= 4e-3;
    const dem::Matrix3 turn =
        polar_split(dem::Matrix3::Identity() + 0.4 * any).rotation;
    const dem::Matrix3 turned_F = turn * Q * F * Q.transpose();
    Deformation x, y;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        x.relative_F[a][b] = F(a, b);
        y.relative_F[a][b] = turned_F(a, b);
      }
    Q = turn * Q;
    const auto plain = evaluate(straight, x), rotated = evaluate(turning, y);
    const dem::Matrix3 wanted =
        Q * to_matrix(dealii::Tensor<2, 3>(plain[0].stress)) * Q.transpose();
    const dem::Matrix3 found =
        to_matrix(dealii::Tensor<2, 3>(rotated[0].stress));
    // Round-off of the stretches, as slips follow it.
    EXPECT_LT((found - wanted).norm(), 1e-12 * wanted.norm()) << step;
    EXPECT_EQ(straight.report().mean_evaluations(),
              turning.report().mean_evaluations());
    straight.commit();
    turning.commit();
  }
}

/// Physics of a rigid turn, verification value V16: a stressed cell that makes
/// a full turn keeps the invariants of its stress and slides nowhere.
TEST(UnitCellPoints, AFullTurnLeavesTheInvariantsOfTheStress)
{
  UnitCellPoints points(test::same_cells(1), test::cold());
  evaluate(points, pressed(5e-3));
  points.commit();
  const dealii::SymmetricTensor<2, 3> first =
      evaluate(points, Deformation{dealii::unit_symmetric_tensor<3>()})[0]
          .stress;
  const std::size_t sliding = dem::measure(points.cell(0)).sliding_contacts;
  constexpr int parts = 60;
  const double angle = 2 * std::numbers::pi / parts;
  Deformation turn;
  turn.relative_F[0][0] = turn.relative_F[2][2] = std::cos(angle);
  turn.relative_F[0][2] = -(turn.relative_F[2][0] = std::sin(angle));
  turn.relative_F[1][1] = 1;
  dealii::SymmetricTensor<2, 3> stress;
  for (int k = 1; k <= parts; ++k) {
    stress = evaluate(points, turn)[0].stress;
    points.commit();
    EXPECT_NEAR(trace(stress), trace(first), 1e-3 * std::abs(trace(first)));
    EXPECT_NEAR(second_invariant(stress),
                second_invariant(first),
                1e-3 * std::abs(second_invariant(first)));
    EXPECT_NEAR(determinant(stress),
                determinant(first),
                1e-3 * std::abs(determinant(first)));
    if (k == parts / 4) { // a quarter of the way x stands where z was
      EXPECT_NEAR(stress[0][0], first[2][2], 1e-3 * first.norm());
      EXPECT_GT(std::abs(first[0][0] - first[2][2]), 0.05 * first.norm());
    }
  }
  EXPECT_LT((stress - first).norm(), 1e-3 * first.norm());
  EXPECT_EQ(dem::measure(points.cell(0)).sliding_contacts, sliding);
}

TEST(UnitCellPoints, TangentOfATurnedLatticeIsTheSlopeOfItsAnswers)
{
  // Motion is affine by symmetry, so that Voigt's tangent is exact; central
  // differences are off by (strain / overlap)^2 / 24.
  constexpr double differences = 1e-6, overlap = 1e-2, strain = 1e-5;
  dem::ContactModel sticking;
  sticking.normal_law = dem::NormalLaw::hertz;
  sticking.friction_coefficient = 10;
  UnitCellPoints points({dem::test::fcc_cell(overlap, sticking)}, test::cold());
  const double angle = 0.6;
  Deformation turn;
  turn.relative_F[0][0] = turn.relative_F[2][2] = std::cos(angle);
  turn.relative_F[0][2] = -(turn.relative_F[2][0] = std::sin(angle));
  turn.relative_F[1][1] = 1;
  std::vector<Response> answer(1);
  points.evaluate(std::span(&turn, 1), Want::stress, answer);
  points.commit();
  const dealii::Tensor<2, 3> one(dealii::unit_symmetric_tensor<3>());
  const dealii::SymmetricTensor<4, 3> tangent =
      evaluate(points, Deformation{one})[0].tangent;
  for (unsigned a = 0; a < 3; ++a)
    for (unsigned b = a; b < 3; ++b) {
      dealii::SymmetricTensor<2, 3> unit;
      unit[a][b] = 1;
      const dealii::Tensor<2, 3> step = strain * dealii::Tensor<2, 3>(unit);
      const auto ahead = evaluate(points, Deformation{one + step})[0].stress;
      const auto back = evaluate(points, Deformation{one - step})[0].stress;
      EXPECT_LT((tangent * unit - (ahead - back) / (2 * strain)).norm(),
                differences * tangent.norm())
          << a << b;
    }
}

TEST(UnitCellPoints, DensityFollowsTheVolume)
{
  UnitCellPoints points(test::same_cells(1), {});
  const double start = points.cell(0).relative_density();
  double volume = 1;
  for (int step = 0; step < 20; ++step) {
    const auto answer = evaluate(points, pressed(5e-3));
    points.commit();
    volume *= 1 - 5e-3;
    EXPECT_NEAR(answer[0].relative_density * volume / start, 1, 1e-12);
  }
}

TEST(UnitCellPoints, PackedStateContinuesToTheBit)
{
  UnitCellPoints points(test::different_cells(2), {});
  for (int step = 0; step < 3; ++step) {
    evaluate(points, pressed(5e-3));
    points.commit();
  }
  UnitCellPoints copy(test::same_cells(2), {});
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<char> bytes;
    points.pack(i, bytes);
    copy.unpack(i, bytes);
  }
  const auto x = evaluate(points, pressed(5e-3));
  const auto y = evaluate(copy, pressed(5e-3));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(x[i].stress, y[i].stress);
    EXPECT_EQ(x[i].tangent, y[i].tangent);
  }
}

TEST(UnitCellPoints, ReportsWhatACellThatDoesNotSettleLeft)
{
  CellPointsOptions options;
  options.driving.quasi_static.maximum_evaluations = 3;
  UnitCellPoints points(test::same_cells(2), options);
  const auto answer = evaluate(points, pressed(5e-3));
  EXPECT_EQ(answer[0].status, fem::Status::doubtful);
  EXPECT_EQ(points.report().unsettled, 2u);
  EXPECT_GT(points.report().worst_unbalance,
            options.driving.quasi_static.unbalance_tolerance);
}

TEST(UnitCellPoints, WorkOfContactsIsWorkOfStress)
{
  UnitCellPoints points(test::different_cells(4), {});
  for (int step = 0; step < 10; ++step) {
    evaluate(points, pressed(5e-3));
    // The residual is of the order of the unbalance that is left.
    EXPECT_LT(points.report().worst_hill_mandel, 5e-3);
    EXPECT_LT(points.report().worst_asymmetry, 1e-3);
    points.commit();
  }
}

TEST(UnitCellPoints, WrongNumberOfDeformationsIsRefused)
{
  UnitCellPoints points(test::same_cells(2), {});
  std::vector<Response> responses(2);
  EXPECT_THROW(points.evaluate(std::vector<Deformation>(1, pressed(1e-3)),
                               Want::stress,
                               responses),
               std::invalid_argument);
}
} // namespace
} // namespace tamp::coupling
