// SPDX-License-Identifier: BSD-3-Clause
#include <dem/condensed_tangent.h>
#include <dem/measures.h>
#include <dem/probed_tangent.h>
#include <dem/stretch.h>
#include <tests/dem/sample_cells.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
ContactModel sticking()
{
  ContactModel contact;
  contact.normal_law = NormalLaw::hertz;
  contact.friction_coefficient = 10;
  return contact;
}

/// Settles a cell to nine digits.
void settle(UnitCell &cell)
{
  Driving fine;
  fine.quasi_static.unbalance_tolerance = 1e-9;
  fine.quasi_static.maximum_evaluations = 50000;
  ASSERT_EQ(deform(cell, Stretch::Identity(), fine).outcome, Outcome::settled);
}

/// Elastic grains, packed without friction, that now stick to each other.
const UnitCell &sticking_cell()
{
  static const UnitCell cell = [] {
    PackingRequest request = test::alumina_request();
    request.contact = sticking();
    request.friction_during_packing = 0;
    UnitCell made = make_packing(request);
    settle(made);
    return made;
  }();
  return cell;
}

/// The quadratic form of a tangent: shear components count twice.
Tangent energy(Tangent tangent)
{
  tangent.bottomRows<3>() *= 2;
  return tangent;
}

double distance(const Tangent &found, const Tangent &wanted)
{
  return (found - wanted).norm() / wanted.norm();
}

TEST(CondensedStiffness, OfALatticeIsVoigts)
{
  constexpr double round_off = 1e-10;
  const UnitCell cell = test::fcc_cell(1e-3, sticking());
  const SolvedTangent found = condensed_stiffness(cell, {});
  ASSERT_TRUE(found.converged);
  EXPECT_LT(distance(found.tangent, voigt_stiffness(cell)), round_off);
  const SolvedTangent stressed = condensed_tangent(cell, {});
  ASSERT_TRUE(stressed.converged);
  EXPECT_LT(distance(stressed.tangent, voigt_tangent(cell)), round_off);
}

TEST(CondensedStiffness, IsSymmetricAndBelowVoigts)
{
  constexpr double accuracy = 1e-7; // of the balance: 1e-8
  const UnitCell &cell = sticking_cell();
  const SolvedTangent found = condensed_stiffness(cell, {});
  ASSERT_TRUE(found.converged);
  const Tangent form = energy(found.tangent);
  EXPECT_LT((form - form.transpose()).norm(), accuracy * form.norm());
  const Tangent gap = energy(voigt_stiffness(cell)) - form;
  const auto least = [](const Tangent &matrix) {
    const Tangent symmetric = 0.5 * (matrix + matrix.transpose());
    return Eigen::SelfAdjointEigenSolver<Tangent>(symmetric)
        .eigenvalues()
        .minCoeff();
  };
  EXPECT_GT(least(form), 0);
  EXPECT_GT(least(gap), 0.01 * form.norm()); // no strain is affine
}

TEST(ContactNetwork, DoesNotAnswerToARotation)
{
  constexpr double accuracy = 1e-7; // of the balance: 1e-8
  Matrix3 spin;
  spin << 0, 1, -2, -1, 0, 3, 2, -3, 0;
  const ContactNetwork network(sticking_cell(), {});
  const auto found = network.respond({spin, Matrix3::Identity()});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LT(found[0].stress_change.norm(),
            accuracy * found[1].stress_change.norm());
}

TEST(ContactNetwork, TurnsTheForcesOfARotatedCell)
{
  // f -> (I + W) f and the branches of the old cell: W . stress.
  constexpr double friction = 1e-4; // what little there is does not turn
  Matrix3 spin;
  spin << 0, 1, -2, -1, 0, 3, 2, -3, 0;
  NetworkChoice turning;
  turning.turning = true;
  const auto found = ContactNetwork(sticking_cell(), turning).respond({spin});
  ASSERT_EQ(found.size(), 1u);
  const Matrix3 wanted = spin * love_weber_stress(sticking_cell());
  EXPECT_LT((found[0].stress_change - wanted).norm(), friction * wanted.norm());
}

TEST(ContactNetwork, WithoutContactsAnswersNothing)
{
  UnitCell cell = test::fcc_cell(1e-3, sticking());
  cell.box.h *= 1.01;
  const SolvedTangent found = condensed_tangent(cell, {});
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.tangent.norm(), 0);
}

TEST(ContactNetwork, RefusesImpossibleChoices)
{
  NetworkChoice choice;
  choice.kept_across = 1.5;
  const std::string message = test::message_of<std::invalid_argument>(
      [&] { ContactNetwork(sticking_cell(), choice); });
  EXPECT_EQ(message, "kept across = 1.5: must be between 0 and 1");
}

TEST(CondensedTangent, IsTheSlopeOfTheMapWhereContactsStick)
{
  // Probes of 1e-6 change overlaps by 1e-4 of themselves, which central
  // differences bring to 1e-8; a few contacts open or close.
  constexpr double probes = 1e-4;
  const UnitCell &cell = sticking_cell();
  const SolvedTangent wanted = probed_tangent(cell, {});
  ASSERT_TRUE(wanted.converged);
  const SolvedTangent found = condensed_tangent(cell, {});
  ASSERT_TRUE(found.converged);
  EXPECT_LT(distance(found.tangent, wanted.tangent), probes);
  // Neither the turning of contacts nor the motion of grains can be left out.
  EXPECT_GT(distance(condensed_stiffness(cell, {}).tangent, wanted.tangent),
            20 * probes);
  EXPECT_GT(distance(voigt_tangent(cell), wanted.tangent), 0.1);
}

TEST(CondensedTangent, IsTheSlopeOfTheMapOfSmoothGrains)
{
  constexpr double probes = 1e-3; // nearer to jamming: more contacts change
  UnitCell cell = test::smooth_elastic_cell();
  settle(cell);
  const SolvedTangent wanted = probed_tangent(cell, {});
  ASSERT_TRUE(wanted.converged);
  const SolvedTangent found = condensed_tangent(cell, {});
  ASSERT_TRUE(found.converged);
  EXPECT_LT(distance(found.tangent, wanted.tangent), probes);
  EXPECT_GT(distance(voigt_tangent(cell), wanted.tangent), 0.5);
}

TEST(CondensedTangent, WithFrictionForcesIsCloseToTheSlopeOfTheMap)
{
  // Left out: the turning of tangential forces, N / (k d) = 1e-2 times their
  // share of the normal ones, and that they fall with the contact radius.
  constexpr double left_out = 0.02;
  PackingRequest request = test::alumina_request();
  request.contact = sticking();
  request.friction_during_packing = 0.3;
  UnitCell cell = make_packing(request); // friction now holds whatever comes
  settle(cell);
  const SolvedTangent wanted = probed_tangent(cell, {});
  ASSERT_TRUE(wanted.converged);
  const SolvedTangent found = condensed_tangent(cell, {});
  ASSERT_TRUE(found.converged);
  EXPECT_LT(distance(found.tangent, wanted.tangent), left_out);
}

TEST(CondensedTangent, FollowsPlasticSlidingGrainsAlongTheirPath)
{
  // Of a state reached by a small step of a path, contacts that slid and
  // yielded go on doing so. Probes around a step of 1e-4 see a few that change
  // their mind.
  constexpr double changed = 0.1;
  constexpr double step = -1e-4;
  UnitCell cell = test::alumina_cell();
  ASSERT_EQ(test::compress(cell, -0.02, 10, {}).outcome, Outcome::settled);
  settle(cell);
  Probing probing;
  probing.path(1, 1) = step;
  const SolvedTangent wanted = probed_tangent(cell, probing);
  ASSERT_TRUE(wanted.converged);

  Driving fine;
  fine.quasi_static.unbalance_tolerance = 1e-6;
  ASSERT_EQ(deform(cell, exponential(probing.path), fine).outcome,
            Outcome::settled);
  NetworkChoice sliding;
  sliding.sliding = true;
  const SolvedTangent found = condensed_tangent(cell, sliding);
  ASSERT_TRUE(found.converged);
  EXPECT_LT(distance(found.tangent, wanted.tangent), changed);
  // Without sliding, or with all grains in the affine field, it is no use.
  EXPECT_GT(distance(condensed_tangent(cell, {}).tangent, wanted.tangent), 0.5);
  EXPECT_GT(distance(voigt_tangent(cell), wanted.tangent), 1);
}

TEST(CondensedTangent, OfElasticGrainsGrowsWithTheRootsOfThePressure)
{
  // p^(1/3) for Hertz at a constant network; new contacts add to it near
  // jamming. Makse et al. (1999), Phys. Rev. Lett. 83:5070.
  UnitCell cell = sticking_cell();
  struct Moduli {
    double pressure, bulk, shear;
  };
  const auto measured = [&] {
    const SolvedTangent found = condensed_stiffness(cell, {});
    EXPECT_TRUE(found.converged);
    const Tangent &c = found.tangent;
    const double bulk = c.topLeftCorner<3, 3>().sum() / 9;
    // Mean of the five deviatoric ones; columns of tensor shear strain.
    const double shear = (c.topLeftCorner<3, 3>().trace() - 3 * bulk +
                          c.bottomRightCorner<3, 3>().trace()) /
                         10;
    return Moduli{-love_weber_stress(cell).trace() / 3, bulk, shear};
  };
  const Moduli before = measured();
  Moduli after = before;
  while (after.pressure < 10 * before.pressure) {
    ASSERT_EQ(deform(cell, std::exp(-1e-3) * Stretch::Identity(), {}).outcome,
              Outcome::settled);
    after.pressure = -love_weber_stress(cell).trace() / 3;
  }
  after = measured();
  const double decades = std::log(after.pressure / before.pressure);
  for (const double exponent :
       {std::log(after.bulk / before.bulk) / decades,
        std::log(after.shear / before.shear) / decades}) {
    EXPECT_GT(exponent, 1.0 / 3);
    EXPECT_LT(exponent, 0.5);
  }
}
} // namespace
} // namespace tamp::dem
