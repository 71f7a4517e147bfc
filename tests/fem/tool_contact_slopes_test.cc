// SPDX-License-Identifier: BSD-3-Clause
#include <tests/fem/contact_body.h>

#include <algorithm>
#include <gtest/gtest.h>

namespace tamp::fem
{
namespace
{
using namespace test;

/// The difference quotient of minus a pair's force by the place of its node, or
/// of its tool. @param known  the same pair's slip status must not change.
Vector slope_of(const Body &body,
                std::size_t pair,
                ContactStatus status,
                unsigned axis,
                bool of_tool)
{
  constexpr double step = 1e-11; // [m], of penetrations of 1e-8
  const auto [node, tool, face] = body.contact.pairs()[pair];
  Vector difference;
  for (const double sign : {1., -1.}) {
    NodePositions places = body.places;
    ToolPositions tools = body.tool_places;
    if (of_tool)
      tools[tool] += sign * step;
    else
      places[node][axis] += sign * step;
    const PairForce force = body.contact.forces(places, tools)[pair];
    EXPECT_EQ(force.status, status);
    difference -= sign * force.force;
  }
  return difference / (2 * step);
}

/// Compares the stiffness of all pairs in this status with differences; the
/// number of pairs.
unsigned compare_stiffness(const Body &body, ContactStatus wanted)
{
  // Rounding of 1e-18 m in places of 1e-3 m makes 1e-7 of the quotient, the
  // curvature of forces 1e-11 / 1e-8 squared.
  constexpr double tolerance = 2e-5;
  unsigned compared = 0;
  const auto forces = body.forces();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (forces[i].status != wanted)
      continue;
    ++compared;
    const auto K =
        body.contact.stiffness(i, forces[i], body.places, body.tool_places);
    for (unsigned c = 0; c < body.mesh.components(); ++c) {
      const unsigned j = body.mesh.axis(c);
      const Vector slope = slope_of(body, i, wanted, j, false);
      for (unsigned d = 0; d < body.mesh.components(); ++d)
        EXPECT_NEAR(slope[body.mesh.axis(d)],
                    K[body.mesh.axis(d)][j],
                    tolerance * K.norm())
            << "pair " << i << " of tool " << body.contact.pairs()[i].tool
            << " by axis " << j;
    }
    const Vector of_tool = slope_of(body, i, wanted, 2, true);
    for (unsigned d = 0; d < body.mesh.components(); ++d)
      EXPECT_NEAR(of_tool[body.mesh.axis(d)],
                  -K[body.mesh.axis(d)][2],
                  tolerance * K.norm())
          << "pair " << i << " of tool " << body.contact.pairs()[i].tool;
  }
  return compared;
}
} // namespace

TEST(ToolContact, StickStiffnessIsTheDerivativeOfTheForces)
{
  for (const Case &now : cases()) {
    SCOPED_TRACE(now.name);
    Body body(now.geometry, FrictionCoefficient(0.5));
    body.settle(1e-8);
    body.push(2e-8, 2e-8); // a tenth of a limit's way
    EXPECT_GT(compare_stiffness(body, ContactStatus::stick), 10u);
  }
}

TEST(ToolContact, SlipStiffnessIsTheDerivativeOfTheForces)
{
  for (const Case &now : cases()) {
    SCOPED_TRACE(now.name);
    Body body(now.geometry, FrictionCoefficient(0.3));
    body.settle(1e-8);
    body.push(2e-8, 1e-4);
    EXPECT_GT(compare_stiffness(body, ContactStatus::slip), 5u);
  }
}

TEST(ToolContact, SlipStiffnessKnowsThatFrictionChangesWithPressure)
{
  for (const Case &now : cases()) {
    SCOPED_TRACE(now.name);
    Body body(now.geometry, FrictionCoefficient(0));
    body.push(1e-7, 0);
    double pressure = 0; // the largest in the trials that follow
    body.begin();
    const auto forces = body.forces();
    for (std::size_t i = 0; i < forces.size(); ++i)
      pressure = std::max(pressure, forces[i].normal / body.contact.area(i));
    Body same(now.geometry, falling_with_pressure(4 * pressure));
    same.settle(1e-8);
    same.push(2e-7, 1e-4);
    EXPECT_GT(compare_stiffness(same, ContactStatus::slip), 5u);
  }
}

} // namespace tamp::fem
