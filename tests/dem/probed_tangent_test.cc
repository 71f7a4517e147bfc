// SPDX-License-Identifier: BSD-3-Clause
#include <dem/probed_tangent.h>
#include <tests/dem/sample_cells.h>

#include <gtest/gtest.h>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
constexpr double overlap_ratio = 1e-3; // overlap over distance of centres

UnitCell lattice(TangentialLaw tangential)
{
  ContactModel contact;
  contact.tangential_law = tangential;
  contact.normal_law = NormalLaw::hertz;
  contact.friction_coefficient = 10;
  return test::fcc_cell(overlap_ratio, contact);
}

TEST(ProbedTangent, OfALatticeIsVoigts)
{
  // Motion is affine by symmetry, so that Voigt's bound is exact. Central
  // differences are off by (strain / overlap_ratio)^2 / 24, one-sided ones by
  // strain / overlap_ratio / 4, a quarter of that for the elastic force.
  const UnitCell cell = lattice(TangentialLaw::mindlin);
  const Tangent wanted = voigt_tangent(cell);
  Probing probing;
  probing.strain = 1e-2 * overlap_ratio;
  const SolvedTangent central = probed_tangent(cell, probing);
  ASSERT_TRUE(central.converged);
  EXPECT_LT((central.tangent - wanted).norm(), 2e-5 * wanted.norm());
  probing.central = false;
  const SolvedTangent forward = probed_tangent(cell, probing);
  ASSERT_TRUE(forward.converged);
  EXPECT_LT((forward.tangent - wanted).norm(), 5e-3 * wanted.norm());
  EXPECT_GT((forward.tangent - wanted).norm(), 5e-4 * wanted.norm());
}

TEST(ProbedTangent, AroundAPathIsThatOfTheCellThere)
{
  // Smooth elastic contacts do not ask how they came there: a lattice pressed
  // along y, then probed, is the lattice there. The stretches do not commute.
  constexpr double central_differences = 2e-5;
  const UnitCell cell = lattice(TangentialLaw::none);
  Probing probing;
  probing.strain = 1e-2 * overlap_ratio;
  probing.path(1, 1) = -2e-4;
  const SolvedTangent found = probed_tangent(cell, probing);
  ASSERT_TRUE(found.converged);
  UnitCell there = cell;
  deform(there, test::uniaxial(-2e-4), {});
  Probing around = probing;
  around.path.setZero();
  const SolvedTangent wanted = probed_tangent(there, around);
  EXPECT_LT((found.tangent - wanted.tangent).norm(),
            central_differences * wanted.tangent.norm());
  EXPECT_GT((found.tangent - voigt_tangent(cell)).norm(),
            0.01 * wanted.tangent.norm());
}

TEST(ProbedTangent, SaysWhereAProbeDoesNotSettle)
{
  Probing probing;
  probing.maximum_evaluations = 2;
  EXPECT_FALSE(probed_tangent(test::alumina_cell(), probing).converged);
}

TEST(ProbedTangent, RefusesImpossibleProbes)
{
  Probing probing;
  probing.strain = 0;
  EXPECT_EQ(test::message_of<std::invalid_argument>([&] {
              (void)probed_tangent(lattice(TangentialLaw::mindlin), probing);
            }),
            "probe strain = 0: must be positive");
  probing.strain = 0.1;
  EXPECT_EQ(test::message_of<std::invalid_argument>([&] {
              (void)probed_tangent(lattice(TangentialLaw::mindlin), probing);
            }),
            "probe strain = 0.1: must be at most 1e-3");
}
} // namespace
} // namespace tamp::dem
