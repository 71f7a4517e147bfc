// SPDX-License-Identifier: BSD-3-Clause
#include <fem/tool_surface.h>

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace tamp::fem
{
namespace
{
using Point = Profile::Point;
using Vector = dealii::Tensor<1, 3>;

/// A bell that is seen from outside: a dome, a neck and a brim.
Profile bell()
{
  return Profile({Point({-3, -1}),
                  Point({-1, -1}),
                  Point({-1, 1}),
                  Point({1, 1}),
                  Point({1, -1}),
                  Point({3, -1})},
                 {0.5, 1, 1, 0.5});
}

/// A hollow square whose corners are rounded and sharp.
Profile square()
{
  return Profile({Point({1, 1}),
                  Point({-1, 1}),
                  Point({-1, -1}),
                  Point({1, -1}),
                  Point({1, 1})},
                 {0.4, 0, 0.4, 0});
}

class Places
{
public:
  /// Uniform in [-2, 2]^3.
  Vector next()
  {
    Vector place;
    for (unsigned axis = 0; axis < 3; ++axis)
      place[axis] = uniform_(engine_);
    return place;
  }

private:
  std::mt19937 engine_{2};
  std::uniform_real_distribution<double> uniform_{-2, 2};
};

/// Distance and normal are compared with central differences wherever the
/// normal changes smoothly. Returns the share of the places compared.
double compare_with_differences(const ToolSurface &surface)
{
  constexpr double step = 1e-5;
  // Curvatures are below 50 where compared: third derivatives of the distance
  // over 6 give errors of 50^2 * step^2, fourth ones of 50^3 * step^2.
  constexpr double slope_tolerance = 1e-6, gradient_tolerance = 5e-5;
  constexpr unsigned number = 5000;
  unsigned compared = 0;
  Places places;
  for (unsigned n = 0; n < number; ++n) {
    const Vector x = places.next();
    const SurfacePoint here = surface.nearest(x);
    bool smooth = here.normal_gradient.norm() < 50;
    Vector slope;
    dealii::Tensor<2, 3> gradient;
    for (unsigned j = 0; j < 3; ++j) {
      Vector shift;
      shift[j] = step;
      const SurfacePoint after = surface.nearest(x + shift);
      const SurfacePoint before = surface.nearest(x - shift);
      slope[j] = (after.distance - before.distance) / (2 * step);
      for (unsigned i = 0; i < 3; ++i)
        gradient[i][j] = (after.normal[i] - before.normal[i]) / (2 * step);
      smooth = smooth && (after.normal - before.normal).norm() < 0.01 &&
               (after.normal_gradient - before.normal_gradient).norm() < 0.1;
    }
    if (!smooth)
      continue;
    ++compared;
    EXPECT_NEAR(here.normal.norm(), 1, 1e-14) << x; // rounding
    EXPECT_NEAR((slope - here.normal).norm(), 0, slope_tolerance) << x;
    const dealii::Tensor<2, 3> expected = here.normal_gradient;
    EXPECT_NEAR((gradient - expected).norm(), 0, gradient_tolerance) << x;
  }
  return static_cast<double>(compared) / number;
}

/// No distance changes by more than the way between two places.
void expect_continuous(const ToolSurface &surface)
{
  Places places;
  for (unsigned n = 0; n < 5000; ++n) {
    const Vector x = places.next();
    const Vector way = 1e-3 * places.next();
    EXPECT_LE(std::abs(surface.nearest(x + way).distance -
                       surface.nearest(x).distance),
              way.norm() * (1 + 1e-9)) // rounding
        << x;
  }
}
} // namespace

TEST(ToolSurface, DerivativesOfARevolvedSurfaceAreThoseOfItsDistance)
{
  EXPECT_GT(compare_with_differences(ToolSurface::revolved(bell())), 0.9);
}

TEST(ToolSurface, DerivativesOfAnExtrudedSurfaceAreThoseOfItsDistance)
{
  EXPECT_GT(compare_with_differences(ToolSurface::extruded(square())), 0.9);
}

TEST(ToolSurface, DerivativesAtARimAreThoseOfItsDistance)
{
  EXPECT_GT(compare_with_differences(ToolSurface::extruded(square(), 0.5)),
            0.9);
}

TEST(ToolSurface, DistancesAreContinuous)
{
  expect_continuous(ToolSurface::revolved(bell()));
  expect_continuous(ToolSurface::extruded(square()));
  expect_continuous(ToolSurface::extruded(square(), 0.5));
}

TEST(ToolSurface, ATurnedDomeIsASphere)
{
  const ToolSurface surface = ToolSurface::revolved(bell());
  dealii::SymmetricTensor<2, 3> unit;
  for (unsigned i = 0; i < 3; ++i)
    unit[i][i] = 1;
  constexpr double tolerance = 1e-9; // rounding over 1e-6
  // The dome's centre is the origin; also on its axis and next to it.
  for (const double z : {0.5, 1., 2.})
    for (const double r : {0., 1e-300, 1e-17, 1e-12, 1e-9, 1e-6, 1e-2, 0.5})
      for (const double angle : {0., 0.7, 3., -1.3}) {
        const Vector x({r * std::cos(angle), r * std::sin(angle), z});
        const SurfacePoint point = surface.nearest(x);
        const Vector radial = x / x.norm();
        EXPECT_NEAR(point.distance, x.norm() - 1, 1e-14); // rounding
        EXPECT_NEAR((point.normal - radial).norm(), 0, 1e-14);
        const auto expected =
            (unit - symmetrize(outer_product(radial, radial))) / x.norm();
        EXPECT_NEAR((point.normal_gradient - expected).norm(), 0, tolerance)
            << x;
      }
}

TEST(ToolSurface, OnTheAxisTheNormalIsFiniteAndAlongIt)
{
  const Vector axis({0, 0, 1});
  const auto cone = ToolSurface::revolved(
      Profile({Point({-1, -1}), Point({0, 0}), Point({1, -1})}));
  const auto flat =
      ToolSurface::revolved(Profile({Point({1, 0}), Point({-1, 0})}));
  for (const double z : {-0.5, 0., 0.5}) {
    const SurfacePoint tip = cone.nearest(z * axis);
    EXPECT_EQ(tip.normal, axis) << z;
    EXPECT_TRUE(std::isfinite(tip.normal_gradient.norm())) << z;
    const SurfacePoint face = flat.nearest(z * axis);
    EXPECT_EQ(face.normal, -axis) << z;
    EXPECT_EQ(face.normal_gradient.norm(), 0) << z;
  }
  const auto bore =
      ToolSurface::revolved(Profile({Point({1, 0}), Point({1, 1})}));
  EXPECT_EQ(bore.nearest({}).distance, 1);
  EXPECT_EQ(bore.nearest({}).normal.norm(), 1);
}

TEST(ToolSurface, AboveItsRimAnExtrudedToolIsAbsent)
{
  constexpr double rim = 0.5;
  const auto surface = ToolSurface::extruded(square(), rim);
  Places places;
  for (unsigned n = 0; n < 1000; ++n) {
    Vector x = places.next();
    x[2] = rim + 1e-6 + std::abs(x[2]);
    EXPECT_GT(surface.nearest(x).distance, 0) << x;
  }
  const SurfacePoint below = surface.nearest(Vector({1.1, 0, 0.3}));
  EXPECT_NEAR(below.distance, -0.1, 1e-15); // rounding
  EXPECT_EQ(below.normal, Vector({-1, 0, 0}));
}
} // namespace tamp::fem
