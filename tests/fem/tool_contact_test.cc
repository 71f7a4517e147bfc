// SPDX-License-Identifier: BSD-3-Clause
#include <tests/fem/contact_body.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace tamp::fem
{
using namespace test;

TEST(ToolContact, NodesAwayFromTheToolsFeelNothing)
{
  for (const Case &now : cases()) {
    SCOPED_TRACE(now.name);
    Body body(now.geometry, FrictionCoefficient(0.3));
    body.begin();
    body.push(-1e-5, 0);
    const auto forces = body.forces();
    for (std::size_t i = 0; i < forces.size(); ++i) {
      if (body.surface(i).distance <= 0) // a neighbour's push
        continue;
      EXPECT_EQ(forces[i].status, ContactStatus::open);
      EXPECT_EQ(forces[i].force.norm() + forces[i].normal, 0);
      EXPECT_EQ(
          body.contact.stiffness(i, forces[i], body.places, body.tool_places)
              .norm(),
          0);
    }
    const ToolForces sums = body.contact.sums(forces);
    EXPECT_EQ(sums[upper_punch].force.norm() + sums[upper_punch].area, 0);
    EXPECT_EQ(sums[lower_punch].force.norm() + sums[lower_punch].area, 0);
  }
}

TEST(ToolContact, FrictionOpposesSlipAndIsCappedByCoulombsLimit)
{
  constexpr double mu = 0.3;
  for (const Case &now : cases()) {
    SCOPED_TRACE(now.name);
    for (const double slide : {1e-8, 1e-5}) {
      Body body(now.geometry, FrictionCoefficient(mu));
      body.begin();
      const NodePositions before = body.places;
      body.push(1e-8, slide);
      unsigned sliding = 0, sticking = 0;
      const auto forces = body.forces();
      for (std::size_t i = 0; i < forces.size(); ++i) {
        const PairForce &pair = forces[i];
        if (pair.status == ContactStatus::open)
          continue;
        const unsigned node = body.contact.pairs()[i].node;
        const Vector motion = body.places[node] - before[node];
        const Vector &n = pair.normal_direction;
        const Vector slip = motion - (motion * n) * n;
        const double limit = mu * pair.normal;
        constexpr double rounding = 1e-12;
        EXPECT_GT(pair.normal, 0);
        EXPECT_NEAR(pair.friction * n, 0, rounding * pair.normal);
        // Against the slip, not only opposite in sense.
        EXPECT_NEAR(pair.friction * slip,
                    -pair.friction.norm() * slip.norm(),
                    rounding * pair.normal * slip.norm());
        EXPECT_NEAR(pair.slip, slip.norm(), rounding * slide);
        EXPECT_LE(pair.friction.norm(), limit * (1 + rounding));
        if (pair.status == ContactStatus::slip) {
          EXPECT_NEAR(pair.friction.norm(), limit, rounding * pair.normal);
          ++sliding;
        } else {
          ++sticking;
        }
      }
      EXPECT_GT(slide > 1e-7 ? sliding : sticking, 5u);
    }
  }
}

TEST(ToolContact, PowderAndToolsMovedTogetherFeelNoChange)
{
  // Places of 1e-3 m are rounded by 1e-18 m, of penetrations of 1e-8 m.
  constexpr double rounding = 1e-8;
  for (const Case &now : cases()) {
    SCOPED_TRACE(now.name);
    Body body(now.geometry, FrictionCoefficient(0.3));
    body.settle(1e-8);
    body.push(2e-8, 1e-6);
    const auto before = body.forces();
    for (double &tool : body.tool_places)
      tool += 1e-4;
    for (Vector &place : body.places)
      place[2] += 1e-4;
    const auto after = body.forces();
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_LT((after[i].force - before[i].force).norm(),
                rounding * (1 + before[i].force.norm()));
  }
}

TEST(ToolContact, ToolsGetWhatTheNodesGiveAndTheirAreas)
{
  for (const Case &now : cases()) {
    SCOPED_TRACE(now.name);
    Body body(now.geometry, FrictionCoefficient(0.3));
    body.begin();
    body.push(1e-8, 1e-6);
    const auto forces = body.forces();
    const ToolForces sums = body.contact.sums(forces);
    Vector of_nodes, of_tools;
    for (const PairForce &pair : forces)
      of_nodes += pair.normal * pair.normal_direction + pair.friction;
    for (const ToolForce &tool : sums)
      of_tools += tool.force;
    constexpr double rounding = 1e-12;
    EXPECT_LT((of_nodes - of_tools).norm(), rounding * sums[die_wall].normal);
    // Flat tools press along z with all of their normal force.
    if (now.geometry.upper_face.kind == PunchFace::Kind::flat) {
      double friction = 0;
      for (std::size_t i = 0; i < forces.size(); ++i)
        if (body.contact.pairs()[i].tool == upper_punch)
          friction += std::abs(forces[i].friction[2]);
      EXPECT_NEAR(sums[upper_punch].force[2],
                  -sums[upper_punch].normal,
                  rounding * sums[upper_punch].normal);
      EXPECT_LT(friction, rounding * sums[upper_punch].normal);
    }
  }
}

TEST(ToolContact, AreasOfTheNodesAddUpToTheTools)
{
  const DieGeometry geometry = round_die(Section::axisymmetric);
  Body body(geometry, FrictionCoefficient(0));
  std::array<double, number_of_tools> area{};
  for (std::size_t i = 0; i < body.contact.pairs().size(); ++i)
    area[body.contact.pairs()[i].tool] += body.contact.area(i);
  const double r = geometry.radius, pi = std::numbers::pi;
  // Rings of straight faces have exactly these areas.
  constexpr double rounding = 1e-12;
  EXPECT_NEAR(area[upper_punch] / (pi * r * r), 1, rounding);
  EXPECT_NEAR(area[lower_punch] / (pi * r * r), 1, rounding);
  EXPECT_NEAR(
      area[die_wall] / (2 * pi * r * geometry.fill_height), 1, rounding);
  EXPECT_NEAR(
      body.contact.element_height() / (geometry.fill_height / 3), 1, rounding);
}

TEST(ToolContact, AugmentedForcesStayWhenThePenetrationsAreGone)
{
  for (const Case &now : cases()) {
    SCOPED_TRACE(now.name);
    Body body(now.geometry, FrictionCoefficient(0));
    body.begin();
    body.push(1e-8, 0);
    const auto pressed = body.forces();
    body.contact.augment(pressed);
    // The same places: what the penetration adds is added once more.
    const auto twice = body.forces();
    for (std::size_t i = 0; i < pressed.size(); ++i)
      EXPECT_NEAR(
          twice[i].normal, 2 * pressed[i].normal, 1e-12 * pressed[i].normal);
    // On the tools: the multipliers alone. Where two tools meet their surfaces
    // are reached to rounding of the places, 1e-10 of the penetration.
    body.push(0, 0);
    const auto exact = body.forces();
    unsigned compared = 0;
    for (std::size_t i = 0; i < pressed.size(); ++i)
      if (std::abs(exact[i].penetration) < 1e-17) {
        ++compared;
        EXPECT_NEAR(
            exact[i].normal, pressed[i].normal, 1e-8 * pressed[i].normal);
      }
    EXPECT_GT(compared, 5u);
  }
}

TEST(ToolContact, ReactionsBalanceTheInternalForces)
{
  // Three sweeps over tools that meet at a right angle leave mu^6.
  constexpr double mu = 0.1, left = 1e-5;
  const DieGeometry geometry = round_die(Section::quarter);
  Body body(geometry, FrictionCoefficient(mu));
  body.begin();
  // On flat tools, slipping upwards along the wall.
  ToolPositions &tools = body.tool_places;
  for (Vector &place : body.places)
    place[2] += 1e-4;
  tools[upper_punch] = tools[lower_punch] = 1e-4;
  std::vector<double> internal(body.mesh.number_of_dofs(), 0.);
  for (double &force : internal)
    force = 10 * body.random();
  body.contact.take_reactions(internal, body.places, tools);
  const auto forces = body.forces();
  std::vector<Vector> of_node(body.mesh.nodes.size());
  for (std::size_t i = 0; i < forces.size(); ++i)
    of_node[body.contact.pairs()[i].node] += forces[i].force;
  unsigned pressed = 0, pulled = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const unsigned node = body.contact.pairs()[i].node;
    const Vector &n = forces[i].normal_direction;
    Vector wanted;
    for (unsigned c = 0; c < 3; ++c)
      wanted[c] = internal[body.mesh.dof(node, c)];
    const double missing = (wanted - of_node[node]) * n;
    EXPECT_GE(forces[i].normal, 0);
    if (forces[i].normal > 0) {
      EXPECT_NEAR(missing, 0, left * 10);
      ++pressed;
    } else { // would have to pull: nothing is left to do for the tool
      EXPECT_LT(missing, left * 10);
      ++pulled;
    }
  }
  EXPECT_GT(pressed, 10u);
  EXPECT_GT(pulled, 10u);
}

TEST(ToolContact, CoefficientIsReadAtTheDensityOfTheNode)
{
  const FrictionCoefficient friction(
      FrictionCoefficient::Of::density,
      DensityTable({{0.3, 0.9}, {0.6, 0.1}}, "friction"));
  Body body(round_die(Section::axisymmetric), friction);
  for (double &density : body.densities)
    density = 0.6 + 0.3 * body.random();
  body.begin();
  body.push(1e-8, 1e-5);
  unsigned sliding = 0;
  const auto forces = body.forces();
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (forces[i].status != ContactStatus::slip)
      continue;
    ++sliding;
    const double density = body.densities[body.contact.pairs()[i].node];
    const double mu = 0.6 - 0.5 * (density - 0.3) / 0.6;
    // Rounding.
    EXPECT_NEAR(forces[i].friction.norm() / forces[i].normal, mu, 1e-12);
  }
  EXPECT_GT(sliding, 5u);
}
} // namespace tamp::fem
