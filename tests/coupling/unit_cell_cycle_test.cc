// SPDX-License-Identifier: BSD-3-Clause
#include <dem/measures.h>
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
using Stress = dealii::SymmetricTensor<2, 3>;

/// Cells that are driven to a balance far below what the excursion changes.
CellPointsOptions fine()
{
  CellPointsOptions options = test::cold();
  options.driving.quasi_static.unbalance_tolerance = 1e-8;
  options.driving.quasi_static.maximum_evaluations = 100000;
  return options;
}

Stress follow(UnitCellPoints &points, const Gradient &F)
{
  fem::Deformation deformation;
  deformation.relative_F = F;
  std::vector<fem::Response> answer(1);
  points.evaluate(std::span(&deformation, 1), fem::Want::stress, answer);
  EXPECT_EQ(answer[0].status, fem::Status::converged);
  points.commit();
  return answer[0].stress;
}

/// A small strain that no principal axis of the die has.
Gradient excursion()
{
  constexpr double size = 1e-5;
  Gradient F;
  F[0][0] = 1 + 0.3 * size;
  F[1][1] = 1 - 0.2 * size;
  F[2][2] = 1 - size;
  F[0][2] = F[2][0] = 0.4 * size;
  return F;
}

Gradient turn()
{
  const double angle = 0.9;
  Gradient Q;
  Q[1][1] = Q[2][2] = std::cos(angle);
  Q[2][1] = -(Q[1][2] = -std::sin(angle));
  Q[0][0] = 1;
  return Q;
}

/// What a cycle was, and left.
struct Cycle {
  double excursion = 0;  ///< change of stress on the way, over the stress [-]
  double left_over = 0;  ///< change of stress at the end, over the excursion
  std::size_t slips = 0; ///< contacts that slide at its end, more than before
};

/// The cycle there and back of a cell that was packed, relieved by a strain of
/// 3e-4, so that no contact is about to yield, and has made the cycle once, so
/// that those that had to slide have done so.
Cycle cycle(const dem::ContactModel &contact, const Gradient &Q)
{
  dem::PackingRequest request = test::granules();
  request.contact = contact;
  UnitCellPoints points({dem::make_packing(request)}, fine());
  const Gradient one = excursion() * invert(excursion());
  follow(points, (1 + 3e-4) * one);
  const Gradient there = Q * excursion();
  follow(points, there);
  const Stress before = follow(points, invert(there));
  const std::size_t sliding = dem::measure(points.cell(0)).sliding_contacts;
  const Stress far =
      symmetrize(transpose(Q) * Gradient(follow(points, there)) * Q);
  const Stress after = follow(points, invert(there));
  const std::size_t now = dem::measure(points.cell(0)).sliding_contacts;
  Cycle result;
  result.excursion = (far - before).norm() / before.norm();
  result.left_over = (after - before).norm() / (far - before).norm();
  result.slips = now - std::min(now, sliding);
  std::cout << "excursion " << result.excursion << " of the stress, left over "
            << result.left_over << " of it, contacts that began to slide "
            << result.slips << " of " << points.cell(0).contacts.size() << "\n";
  return result;
}

dem::ContactModel rubbing(dem::TangentialLaw law)
{
  dem::ContactModel contact = test::granules().contact;
  contact.tangential_law = law;
  return contact;
}

const Gradient still = excursion() * invert(excursion());

TEST(UnitCellCycle, OfSmoothGrainsReturnsToItsStress)
{
  constexpr double returned = 1e-3; // the unbalance over the excursion
  const dem::ContactModel smooth = rubbing(dem::TangentialLaw::none);
  for (const Gradient &Q : {still, turn()}) {
    const Cycle found = cycle(smooth, Q);
    EXPECT_GT(found.excursion, 1e-4);
    EXPECT_LT(found.left_over, returned);
  }
}

TEST(UnitCellCycle, OfMindlinsGrainsLosesWhatTheirContactRadiusTakes)
{
  // The law takes the tangential force down with the contact radius in
  // unloading, and does not give it back: a cycle without any slip loses that.
  constexpr double taken = 0.03;
  const dem::ContactModel mindlin = rubbing(dem::TangentialLaw::mindlin);
  const Cycle found = cycle(mindlin, still), turned = cycle(mindlin, turn());
  EXPECT_GT(found.excursion, 1e-4);
  EXPECT_LT(found.left_over, taken);
  EXPECT_EQ(found.slips, 0u);
  // A rotation on the way is none of the grains' business.
  EXPECT_NEAR(turned.left_over, found.left_over, 1e-3 * found.left_over);
  EXPECT_EQ(turned.slips, 0u);
}
} // namespace
} // namespace tamp::coupling
