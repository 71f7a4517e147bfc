// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/polar.h>
#include <dem/measures.h>
#include <tests/coupling/sample_cells.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <string>
#include <vector>

namespace tamp::coupling
{
namespace
{
using Gradient = dealii::Tensor<2, 3>;
using Stress = dealii::SymmetricTensor<2, 3>;

/// What a cycle may change of the stress, over the excursion.
constexpr double returned = 1e-3;

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

Stress stress_of(const dem::UnitCell &cell)
{
  return to_tensor(dem::measure(cell).stress);
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

Gradient turn_by(double angle)
{
  Gradient Q;
  Q[1][1] = Q[2][2] = std::cos(angle);
  Q[2][1] = -(Q[1][2] = -std::sin(angle));
  Q[0][0] = 1;
  return Q;
}

/// A cycle without a rotation, and one with.
const Gradient rotations[] = {turn_by(0), turn_by(0.9)};

/// A cell of this law and friction, packed, and relieved by a strain of 3e-4,
/// so that no contact is about to yield.
dem::UnitCell relieved(dem::TangentialLaw law, double friction)
{
  dem::PackingRequest request = test::granules();
  request.contact.tangential_law = law;
  request.contact.friction_coefficient = friction;
  dem::UnitCell cell = dem::make_packing(request);
  const dem::CellAnswer answer =
      deform(cell, (1 + 3e-4) * dem::Matrix3::Identity(), fine().driving);
  EXPECT_EQ(answer.outcome, dem::Outcome::settled);
  return cell;
}

/// Contacts that slide in the second cell and did not in the first.
std::size_t slips(const dem::UnitCell &before, const dem::UnitCell &after)
{
  const auto old = dem::contact_forces(before);
  std::size_t result = 0;
  for (const dem::ContactForce &now : dem::contact_forces(after)) {
    const auto same =
        std::ranges::find(old, now.pair, &dem::ContactForce::pair);
    result += now.sliding && (same == old.end() || !same->sliding);
  }
  return result;
}

/// The cells of a cycle: before, at its far end, and after.
struct Stations {
  dem::UnitCell before, away, after;
};

double radius_in(const dem::UnitCell &cell, dem::Pair pair)
{
  const auto found =
      std::ranges::find(cell.contacts, pair, &dem::ContactMemory::pair);
  return found == cell.contacts.end() ? 0 : found->contact_radius;
}

/// Share of its tangential force that Mindlin's law leaves a contact in an
/// increment without slip: an unloading takes it down with the radius.
double share_left(double radius, double next)
{
  return std::min(1.0, next / radius);
}

/// The cell as it was before the cycle, had Mindlin's law but taken its share
/// of every contact, and found its balance again.
dem::UnitCell less_the_law(const Stations &cells)
{
  dem::UnitCell cell = cells.before;
  for (dem::ContactMemory &contact : cell.contacts) {
    const double away = radius_in(cells.away, contact.pair);
    const double after = radius_in(cells.after, contact.pair);
    if (!(away > 0 && after > 0))
      continue; // has parted
    contact.tangential_force *=
        share_left(contact.contact_radius, away) * share_left(away, after);
    contact.contact_radius = after;
  }
  const dem::CellAnswer answer =
      deform(cell, dem::Matrix3::Identity(), fine().driving);
  EXPECT_EQ(answer.outcome, dem::Outcome::settled);
  return cell;
}

/// What a cycle was, and left. All but the first over the excursion.
struct Cycle {
  double excursion = 0;   ///< change of stress on the way, over the stress [-]
  double left_over = 0;   ///< change of stress at the end
  double unexplained = 0; ///< the part that Mindlin's law does not take
  std::size_t slips = 0;  ///< contacts that began to slide, on either way
};

std::ostream &operator<<(std::ostream &out, const Cycle &cycle)
{
  return out << "excursion " << cycle.excursion << " of the stress, left over "
             << cycle.left_over << " of it, not by Mindlin's law "
             << cycle.unexplained << ", contacts that began to slide "
             << cycle.slips << "\n";
}

/// The cycle there and back.
Cycle cycle(UnitCellPoints &points, const Gradient &Q)
{
  const Gradient there = Q * excursion();
  Stations cells;
  cells.before = points.cell(0);
  const Stress far =
      symmetrize(transpose(Q) * Gradient(follow(points, there)) * Q);
  cells.away = points.cell(0);
  const Stress end = follow(points, invert(there));
  cells.after = points.cell(0);
  const Stress start = stress_of(cells.before);
  const double size = (far - start).norm();
  Cycle result;
  result.excursion = size / start.norm();
  result.left_over = (end - start).norm() / size;
  result.unexplained = (end - stress_of(less_the_law(cells))).norm() / size;
  result.slips =
      slips(cells.before, cells.away) + slips(cells.away, cells.after);
  std::cout << result;
  EXPECT_GT(result.excursion, 1e-3); // there was something to return from
  return result;
}

/// The very first cycle of a cell.
Cycle first_cycle(const dem::UnitCell &cell, const Gradient &Q)
{
  UnitCellPoints points({cell}, fine());
  return cycle(points, Q);
}

TEST(UnitCellCycle, OfSmoothGrainsReturnsToItsStress)
{
  const dem::UnitCell cell = relieved(dem::TangentialLaw::none, 0);
  for (const Gradient &Q : rotations)
    EXPECT_LT(first_cycle(cell, Q).left_over, returned);
}

TEST(UnitCellCycle, FromAStateWithoutShearForcesReturnsToItsStress)
{
  // What Mindlin's law takes is in proportion to the tangential forces that the
  // cycle starts with: here they are those of the cycle itself, and the loss of
  // second order.
  for (const double friction : {0.35, 10.}) {
    dem::UnitCell cell = relieved(dem::TangentialLaw::none, friction);
    const Cycle smooth = first_cycle(cell, rotations[0]);
    cell.contact.tangential_law = dem::TangentialLaw::mindlin;
    for (const Gradient &Q : rotations) {
      const Cycle found = first_cycle(cell, Q);
      EXPECT_LT(found.left_over, returned);
      EXPECT_EQ(found.slips, 0u);
      // The tangential forces carry their part of the excursion.
      EXPECT_GT(found.excursion, 1.5 * smooth.excursion);
    }
  }
}

TEST(UnitCellCycle, OfGrainsThatStickLosesWhatMindlinsLawTakesAndNoMore)
{
  for (const double friction : {1., 10.}) {
    const dem::UnitCell cell = relieved(dem::TangentialLaw::mindlin, friction);
    const Cycle found = first_cycle(cell, rotations[0]);
    EXPECT_GT(found.left_over, 10 * returned); // the law takes its share
    EXPECT_LT(found.unexplained, returned);
    EXPECT_EQ(found.slips, 0u);
    // A rotation on the way is none of the grains' business.
    const Cycle turned = first_cycle(cell, rotations[1]);
    EXPECT_NEAR(turned.left_over, found.left_over, 1e-6); // the balance
    EXPECT_LT(turned.unexplained, returned);
    EXPECT_EQ(turned.slips, 0u);
  }
}

TEST(UnitCellCycle, OfGrainsAtTheirCapsSlidesAtFirstAndThenLosesNoMoreThanThat)
{
  const dem::UnitCell cell = relieved(dem::TangentialLaw::mindlin, 0.35);
  for (const Gradient &Q : rotations) {
    UnitCellPoints points({cell}, fine());
    const Cycle first = cycle(points, Q);
    EXPECT_GT(first.slips, 0u);
    EXPECT_GT(first.unexplained, 10 * returned); // work of sliding
    cycle(points, Q);
    cycle(points, Q);
    EXPECT_LT(cycle(points, Q).unexplained, returned);
  }
}
} // namespace
} // namespace tamp::coupling
