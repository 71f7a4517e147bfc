// SPDX-License-Identifier: BSD-3-Clause
#include <fem/profile.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Point = Profile::Point;
using Polygon = std::vector<Point>;

constexpr unsigned sides_per_arc = 2000;

/// A chain with sharp and rounded corners to both sides, some of them acute.
struct Zigzag {
  Polygon corners{Point({-4, 0}),
                  Point({-2, 0}),
                  Point({-1, -1.5}),
                  Point({-0.7, 1}),
                  Point({0.5, 1.2}),
                  Point({0.4, -1}),
                  Point({1.5, -0.8}),
                  Point({1.6, 0.5}),
                  Point({4, 0.4})};
  std::vector<double> radii{0, 0.1, 0, 0.3, 0.2, 0, 0.5};
};

/// The rounded chain as many short straight sides. The centre of an arc is on
/// the bisector, radius / sin(half the angle) from the corner.
Polygon drawn(const Zigzag &zigzag)
{
  Polygon result{zigzag.corners.front()};
  for (std::size_t i = 1; i + 1 < zigzag.corners.size(); ++i) {
    const Point corner = zigzag.corners[i];
    Point back = zigzag.corners[i - 1] - corner;
    Point ahead = zigzag.corners[i + 1] - corner;
    back /= back.norm();
    ahead /= ahead.norm();
    const Point bisector = (back + ahead) / (back + ahead).norm();
    const double cosine = bisector * back,
                 sine = std::sqrt(1 - cosine * cosine);
    const double radius = zigzag.radii[i - 1];
    const Point centre = corner + radius / sine * bisector;
    const Point from = corner + radius * cosine / sine * back - centre;
    const Point to = corner + radius * cosine / sine * ahead - centre;
    for (unsigned k = 0; k <= sides_per_arc; ++k) {
      const double share = static_cast<double>(k) / sides_per_arc;
      const Point way = (1 - share) * from + share * to;
      result.push_back(radius > 0 ? centre + radius / way.norm() * way
                                  : corner);
    }
  }
  result.push_back(zigzag.corners.back());
  return result;
}

double distance_to_side(const Point &x, const Point &from, const Point &to)
{
  const Point side = to - from;
  const double square = side.norm_square();
  const double share =
      square > 0 ? std::clamp((x - from) * side / square, 0., 1.) : 0.;
  return (x - from - share * side).norm();
}

double distance_to(const Polygon &polygon, const Point &x)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i)
    smallest =
        std::min(smallest, distance_to_side(x, polygon[i], polygon[i + 1]));
  return smallest;
}

/// Whether x is above the chain: a ray upwards crosses it an even number of
/// times.
bool is_above(const Polygon &polygon, const Point &x)
{
  bool above = true;
  for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
    const Point from = polygon[i], to = polygon[i + 1];
    if ((from[0] > x[0]) == (to[0] > x[0]))
      continue;
    const double share = (x[0] - from[0]) / (to[0] - from[0]);
    if (from[1] + share * (to[1] - from[1]) > x[1])
      above = !above;
  }
  return above;
}

/// Places in [-2.5, 2.5] x [-2, 2], far from the ends of the zigzag.
class Places
{
public:
  Point next()
  {
    const double x = 5 * uniform_(engine_) - 2.5;
    return Point({x, 4 * uniform_(engine_) - 2});
  }

private:
  std::mt19937 engine_{1};
  std::uniform_real_distribution<double> uniform_{0, 1};
};

Polygon reversed(Polygon polygon)
{
  return {polygon.rbegin(), polygon.rend()};
}

/// The normal's derivative by central differences.
dealii::Tensor<2, 2>
differences(const Profile &profile, const Point &x, double step)
{
  dealii::Tensor<2, 2> result;
  for (unsigned j = 0; j < 2; ++j) {
    Point shift;
    shift[j] = step;
    const auto after = profile.nearest(x + shift);
    const auto before = profile.nearest(x - shift);
    for (unsigned i = 0; i < 2; ++i)
      result[i][j] = (after.normal[i] - before.normal[i]) / (2 * step);
  }
  return result;
}

std::string complaint(const Polygon &corners, const std::vector<double> &radii)
{
  try {
    const Profile profile(corners, radii);
  } catch (const std::invalid_argument &error) {
    return error.what();
  }
  return "";
}
} // namespace

TEST(Profile, DistanceIsThatToTheDrawnChain)
{
  const Zigzag zigzag;
  const Polygon polygon = drawn(zigzag);
  const Profile profile(zigzag.corners, zigzag.radii);
  const Profile back(reversed(zigzag.corners),
                     {zigzag.radii.rbegin(), zigzag.radii.rend()});
  // The sides of the drawn arcs are up to (3 * 0.5 / 2000)^2 / 8 / 0.5 off.
  constexpr double tolerance = 2e-7;
  Places places;
  for (unsigned i = 0; i < 3000; ++i) {
    const Point x = places.next();
    const double expected =
        (is_above(polygon, x) ? 1 : -1) * distance_to(polygon, x);
    EXPECT_NEAR(profile.nearest(x).distance, expected, tolerance) << x;
    EXPECT_NEAR(back.nearest(x).distance, -expected, tolerance) << x;
  }
}

TEST(Profile, NormalAndCurvatureAreTheDerivativesOfTheDistance)
{
  const Zigzag zigzag;
  const Profile profile(zigzag.corners, zigzag.radii);
  constexpr double step = 1e-5;
  unsigned compared = 0, curved = 0;
  Places places;
  for (unsigned i = 0; i < 20000; ++i) {
    const Point x = places.next();
    const ProfilePoint here = profile.nearest(x);
    // A difference across the end of a piece, or where two pieces are equally
    // near, says nothing.
    bool smooth = std::abs(here.curvature) < 50;
    Point slope;
    for (unsigned j = 0; j < 2; ++j) {
      Point shift;
      shift[j] = step;
      const auto after = profile.nearest(x + shift);
      const auto before = profile.nearest(x - shift);
      slope[j] = (after.distance - before.distance) / (2 * step);
      smooth = smooth && std::abs(after.curvature - here.curvature) < 0.1 &&
               std::abs(before.curvature - here.curvature) < 0.1 &&
               (after.normal - before.normal).norm() < 0.01;
    }
    if (!smooth)
      continue;
    ++compared;
    curved += here.curvature != 0;
    // Third derivatives are up to 2 * 50^2: errors of step^2 * 50^2.
    constexpr double tolerance = 1e-6;
    EXPECT_NEAR((slope - here.normal).norm(), 0, tolerance) << x;
    EXPECT_NEAR(here.normal.norm(), 1, 1e-14) << x; // rounding
    const Point tangent({-here.normal[1], here.normal[0]});
    const auto gradient = differences(profile, x, step);
    const auto expected = here.curvature * outer_product(tangent, tangent);
    // Fourth derivatives up to 6 * 50^3, over 6.
    EXPECT_NEAR((gradient - expected).norm(), 0, 50 * tolerance) << x;
  }
  EXPECT_GT(compared, 19000u);
  EXPECT_GT(curved, 5000u);
}

TEST(Profile, PiecesLeaveNoGapsWhereTheyJoin)
{
  const Zigzag zigzag;
  const Profile profile(zigzag.corners, zigzag.radii);
  // Perpendicular to a joint, where rounding decides between two pieces, the
  // distance is that from the joint: on both sides of a rounded corner, on the
  // outer side of a sharp one.
  for (std::size_t i = 1; i + 1 < zigzag.corners.size(); ++i) {
    const double radius = zigzag.radii[i - 1];
    const Point corner = zigzag.corners[i];
    const Point way = corner - zigzag.corners[i - 1];
    const Point ahead = zigzag.corners[i + 1] - corner;
    const Point along = way / way.norm();
    const Point normal({-along[1], along[0]});
    const double half_turn =
        std::acos(way * ahead / way.norm() / ahead.norm()) / 2;
    const Point joint = corner - radius * std::tan(half_turn) * along;
    const double outer = normal * ahead > 0 ? -1 : 1;
    for (const double away : {0., 1e-12, 1e-9, 1e-6, 1e-3, 0.05, 0.09})
      for (const double side : {outer, -outer}) {
        if (!(radius > 0) && side != outer)
          continue;
        const ProfilePoint point =
            profile.nearest(joint + side * away * normal);
        // Pieces overlap by 1e-12 of the size of the chain, 8.
        EXPECT_NEAR(point.distance, side * away, 1e-11);
        EXPECT_NEAR(point.normal.norm(), 1, 1e-14); // rounding
        EXPECT_TRUE(std::isfinite(point.curvature));
      }
  }
}

TEST(Profile, ClosedChainRoundedToTheFullIsACircle)
{
  const Profile circle({Point({1, 1}),
                        Point({-1, 1}),
                        Point({-1, -1}),
                        Point({1, -1}),
                        Point({1, 1})},
                       {1, 1, 1, 1});
  constexpr double tolerance = 1e-14; // rounding
  Places places;
  for (unsigned i = 0; i < 1000; ++i) {
    const Point x = places.next();
    const ProfilePoint point = circle.nearest(x);
    EXPECT_NEAR(point.distance, 1 - x.norm(), tolerance);
    EXPECT_NEAR((point.normal + x / x.norm()).norm(), 0, tolerance / x.norm());
    EXPECT_NEAR(point.curvature * x.norm(), -1, tolerance / x.norm());
  }
  const ProfilePoint centre = circle.nearest(Point());
  EXPECT_NEAR(centre.distance, 1, tolerance);
  EXPECT_NEAR(centre.normal.norm(), 1, tolerance);
  EXPECT_EQ(centre.curvature, 0);
}

TEST(Profile, ClosedChainMayBeginAnywhere)
{
  const Polygon square{
      Point({1, 1}), Point({-1, 1}), Point({-1, -1}), Point({1, -1})};
  const std::vector<double> radii{0.1, 0.2, 0.3, 0};
  const Profile reference(
      {square[0], square[1], square[2], square[3], square[0]},
      {radii[1], radii[2], radii[3], radii[0]});
  // Begins in the middle of a side, which is no corner.
  const Profile other({Point({-1, 0}),
                       square[2],
                       square[3],
                       square[0],
                       square[1],
                       Point({-1, 0})},
                      {radii[2], radii[3], radii[0], radii[1], 0.7});
  Places places;
  for (unsigned i = 0; i < 1000; ++i) {
    const Point x = places.next();
    EXPECT_NEAR(reference.nearest(x).distance,
                other.nearest(x).distance,
                1e-14); // rounding
  }
}

TEST(Profile, CornersOnAStraightLineChangeNothing)
{
  const Profile sparse({Point({0, 0}), Point({1, 0}), Point({1.5, 2})});
  Polygon corners;
  for (unsigned i = 0; i < 100; ++i)
    corners.push_back(Point({i / 100., 0}));
  for (unsigned i = 0; i <= 100; ++i)
    corners.push_back(Point({1 + 0.5 * i / 100, 2. * i / 100}));
  const Profile dense(corners);
  Places places;
  for (unsigned i = 0; i < 1000; ++i) {
    const Point x = places.next();
    const ProfilePoint one = sparse.nearest(x), other = dense.nearest(x);
    // Rounding of the corners' places.
    EXPECT_NEAR(one.distance, other.distance, 1e-13);
    EXPECT_NEAR((one.normal - other.normal).norm(), 0, 1e-13);
  }
}

TEST(Profile, CloseToASharpCornerTheNormalIsTheMeanOfItsSides)
{
  const Profile profile({Point({-1, 0}), Point({0, 0}), Point({0, -1})});
  const ProfilePoint point = profile.nearest(Point({2e-11, 1e-11}));
  EXPECT_NEAR(point.distance, std::sqrt(5.) * 1e-11, 1e-16); // rounding
  EXPECT_EQ(point.curvature, 0);
  const Point mean = Point({1, 1}) / std::sqrt(2.);
  EXPECT_NEAR((point.normal - mean).norm(), 0, 1e-15); // rounding
}

TEST(Profile, ImpossibleChainsAreRefusedNamingTheCorner)
{
  const Point a({0, 0}), b({1, 0}), c({1, 1}), d({2, 1});
  EXPECT_EQ(complaint({a, b, c, d}, {0.5, 0.5}), "");
  EXPECT_EQ(complaint({a, b, c, d}, {0.5, 0.6}),
            "profile: an arc does not fit at corner (1, 1) m; expected a "
            "smaller radius");
  EXPECT_EQ(complaint({a, b, c, d}, {0.5, -0.1}),
            "profile: a negative radius at corner (1, 1) m; expected zero or "
            "more");
  EXPECT_EQ(complaint({a, b, c, d}, {0.5}),
            "profile: there are 1 radii; expected one for each of the 2 inner "
            "corners");
  EXPECT_EQ(complaint({a, b, b, c}, {}),
            "profile: no length at corner (1, 0) m; expected the next corner "
            "elsewhere");
  EXPECT_EQ(complaint({a, b, a}, {}),
            "profile: the chain turns back on itself at corner (0, 0) m; "
            "expected another direction");
  EXPECT_EQ(complaint({a}, {}),
            "profile: there are 1 corners; expected at least two");
}
} // namespace tamp::fem
