// SPDX-License-Identifier: BSD-3-Clause
#include <fem/smooth_chain.h>

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace tamp::fem
{
namespace
{
using Point = Profile::Point;
using Chain = std::vector<Point>;

constexpr double degree = std::numbers::pi / 180;
constexpr double rounding = 1e-14; // of places of about 1

Point on_circle(const Point &centre, double radius, double angle)
{
  return centre + radius * Point({std::cos(angle), std::sin(angle)});
}

/// Nodes on an arc from one angle to another, denser towards its end.
Chain arc(
    const Point &centre, double radius, double from, double to, unsigned sides)
{
  Chain nodes;
  for (unsigned i = 0; i <= sides; ++i) {
    const double share = static_cast<double>(i) / sides;
    nodes.push_back(on_circle(
        centre, radius, from + (to - from) * share * (1.25 - 0.25 * share)));
  }
  return nodes;
}

void append(Chain &chain, const Chain &more)
{
  chain.insert(chain.end(), more.begin() + 1, more.end());
}

/// Angle between the normals a little before and behind a node, seen from the
/// powder's side, beyond what an arc of the smallest radius turns there.
double kink(const Profile &profile, const Point &node, const Point &along)
{
  constexpr double little = 1e-7;
  const auto before = profile.nearest(node - little * along);
  const auto after = profile.nearest(node + little * along);
  return (after.normal - before.normal).norm();
}

double largest_distance(const Profile &profile, const Chain &nodes)
{
  double largest = 0;
  for (const Point &node : nodes)
    largest = std::max(largest, std::abs(profile.nearest(node).distance));
  return largest;
}
} // namespace

TEST(SmoothChain, NodesOfACircleGiveTheCircle)
{
  const Point centre({0.3, -0.2});
  for (const double radius : {0.5, 2., 40.})
    for (const double sense : {1., -1.}) { // powder inside, outside
      const Chain nodes =
          arc(centre, radius, -40 * degree * sense, 50 * degree * sense, 9);
      const Profile profile = smooth_chain(nodes);
      EXPECT_EQ(profile.faces(), 1u);
      for (double angle = -39; angle < 49; angle += 0.7)
        for (const double away : {-0.2, -1e-3, 0., 1e-3, 0.2}) {
          const Point place =
              on_circle(centre, radius + away, sense * angle * degree);
          const ProfilePoint found = profile.nearest(place);
          const Point outwards = (place - centre) / (place - centre).norm();
          EXPECT_NEAR(found.distance, -sense * away, rounding * radius);
          EXPECT_NEAR((found.normal + sense * outwards).norm(), 0, rounding);
          // The centre is a curvature's radius away along the normal. Its arcs
          // are a twentieth of the circle: rounding grows by the square.
          EXPECT_NEAR(found.curvature * (radius + away), -sense, 1e-11);
        }
    }
}

TEST(SmoothChain, FlatCirclesAreMetToRounding)
{
  // From the centre the distance would be rounded by 1e-16 of the radius.
  for (const double radius : {1e3, 1e6}) {
    Chain nodes;
    for (double x = -1; x < 1.01; x += 0.125)
      nodes.push_back(
          Point({x, x * x / (radius + std::sqrt(radius * radius - x * x))}));
    const Profile profile = smooth_chain(nodes);
    EXPECT_LT(largest_distance(profile, nodes), 1e-15) << radius;
    EXPECT_EQ(profile.faces(), 1u);
  }
}

TEST(SmoothChain, NodesLieOnACurveWithoutKinks)
{
  // A wave, with places of no curvature between nodes.
  Chain nodes;
  for (unsigned i = 0; i <= 25; ++i) {
    const double x = 0.25 * i;
    nodes.push_back(Point({x, 0.3 * std::cos(x + 0.1)}));
  }
  const Profile profile = smooth_chain(nodes);
  EXPECT_EQ(profile.faces(), 1u);
  EXPECT_LT(largest_distance(profile, nodes), rounding);
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    const Point along = nodes[i + 1] - nodes[i - 1];
    // The curvature is below 1: 2e-7 of the way there and back.
    EXPECT_LT(kink(profile, nodes[i], along / along.norm()), 4e-7) << i;
  }
}

TEST(SmoothChain, ErrorsFallWithTheThirdPowerOfTheSpacing)
{
  const auto error = [](unsigned sides) {
    const auto wave = [](double x) { return 0.3 * std::cos(x); };
    Chain nodes, between;
    for (unsigned i = 0; i <= 4 * sides; ++i) {
      const double x = 6. * i / (4 * sides);
      (i % 4 ? between : nodes).push_back(Point({x, wave(x)}));
    }
    return largest_distance(smooth_chain(nodes), between);
  };
  // Two at least, as of chords, and a half for the way there.
  EXPECT_GT(std::log2(error(24) / error(48)), 2.5);
}

TEST(SmoothChain, CornersStaySharp)
{
  // A flat punch with a rim at 45, at 30 and at 10 degrees, of one element and
  // of three.
  for (const double angle : {45., 30., 10., -10., -45.})
    for (const unsigned sides : {1u, 3u}) {
      Chain nodes;
      for (unsigned i = 0; i <= 4; ++i)
        nodes.push_back(Point({0.25 * i, 0}));
      for (unsigned i = 1; i <= sides; ++i)
        nodes.push_back(on_circle(nodes[4], 0.2 * i / sides, angle * degree));
      const Profile sharp({nodes.front(), nodes[4], nodes.back()});
      const Profile profile = smooth_chain(nodes);
      EXPECT_EQ(profile.faces(), sharp.faces());
      for (double x = 0.05; x < 1.2; x += 0.01)
        for (const double y : {-0.05, -1e-3, 1e-3, 0.05}) {
          const Point place({x, y});
          EXPECT_NEAR(profile.nearest(place).distance,
                      sharp.nearest(place).distance,
                      rounding)
              << angle << " degrees at " << place;
        }
    }
}

TEST(SmoothChain, AFilletJoinsStraightLines)
{
  // Up a wall, and by a quarter of a circle in three sides on to a ledge.
  Chain nodes{Point({1, -2}), Point({1, -1}), Point({1, 0})};
  for (const double angle : {30., 60., 90.})
    nodes.push_back(on_circle(Point({2, 0}), 1, (180 - angle) * degree));
  append(nodes, {nodes.back(), Point({3, 1}), Point({4, 1})});
  const Profile expected({Point({1, -2}), Point({1, 1}), Point({4, 1})}, {1});
  const Profile profile = smooth_chain(nodes);
  EXPECT_EQ(profile.faces(), 1u);
  for (double x = 0.05; x < 3.5; x += 0.05)
    for (double y = -1.5; y < 1.5; y += 0.05) {
      const Point place({x, y});
      EXPECT_NEAR(profile.nearest(place).distance,
                  expected.nearest(place).distance,
                  1e2 * rounding) // of joints where the pieces' ends meet
          << place;
    }
}

TEST(SmoothChain, ACornerEndsTwoSmoothRuns)
{
  // A cup with a land around: the arc ends at the land's corner.
  Chain nodes = arc(Point({0, 1}), 1, -90 * degree, -30 * degree, 6);
  const Point edge = nodes.back();
  append(nodes, {edge, edge + Point({0.2, 0}), edge + Point({0.4, 0})});
  const Profile profile = smooth_chain(nodes);
  EXPECT_EQ(profile.faces(), 1u); // the corner stands out
  EXPECT_LT(largest_distance(profile, nodes), rounding);
  const double inside = -32 * degree;
  EXPECT_NEAR(profile.nearest(on_circle(Point({0, 1}), 0.9, inside)).distance,
              0.1,
              rounding);
  EXPECT_NEAR(
      profile.nearest(edge + Point({0.1, 0.05})).distance, 0.05, rounding);
  EXPECT_GT(kink(profile, edge, Point({1, 0})), 0.5);
}
} // namespace tamp::fem
