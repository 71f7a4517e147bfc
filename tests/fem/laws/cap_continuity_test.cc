// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/agcusnin.h>
#include <fem/laws/drucker_prager_cap.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

// The stress at the end of an increment is a continuous function of the strain,
// and the tangent is its slope, however many parts the integration takes.
namespace tamp::fem
{
namespace
{
using dealii::Tensor;
using Surface = DruckerPragerCap::Surface;
using State = DruckerPragerCap::State;

Tensor<2, 3> stretch(const std::array<double, 3> &strain)
{
  Tensor<2, 3> F;
  for (unsigned i = 0; i < 3; ++i)
    F[i][i] = std::exp(strain[i]);
  return F;
}

/// A way from `start` to `end`, all of it one increment of the law.
struct Line {
  std::string name;
  double transition;
  std::vector<std::array<double, 3>> before; ///< in twenty increments each
  std::array<double, 3> start, end;
  std::set<Surface> surfaces; ///< that are met on the way
};

class Walk
{
public:
  Walk(DruckerPragerCapParameters parameters, const Line &line)
      : line_(line), law_(with(parameters, line.transition))
  {
    State now = old_;
    for (auto leg : line.before) {
      for (double &strain : leg)
        strain /= 20;
      for (unsigned i = 0; i < 20; ++i, old_ = now)
        EXPECT_NE(law_.respond(old_, now, {stretch(leg)}, Want::stress).status,
                  Status::failed);
    }
  }

  /// Steps of 1/500 of the line, halved where the tangents at the two ends do
  /// not explain the change of stress; a jump stays however small the step is.
  void expect_no_jump()
  {
    std::set<Surface> met;
    Response last = at(0, met);
    for (unsigned i = 1; i <= 500; ++i) {
      const Response next = at(i / 500., met);
      EXPECT_TRUE(is_explained((i - 1) / 500., last, i / 500., next, 0))
          << line_.name << ", step " << i;
      last = next;
    }
    EXPECT_EQ(met, line_.surfaces) << line_.name;
  }

private:
  static DruckerPragerCapParameters with(DruckerPragerCapParameters parameters,
                                         const double transition)
  {
    parameters.transition = transition;
    return parameters;
  }

  Response at(const double share, std::set<Surface> &met) const
  {
    std::array<double, 3> strain;
    for (unsigned k = 0; k < 3; ++k)
      strain[k] = line_.start[k] + share * (line_.end[k] - line_.start[k]);
    State now = old_;
    const auto answer =
        law_.respond(old_, now, {stretch(strain)}, Want::stress_and_tangent);
    EXPECT_EQ(answer.status, Status::converged) << line_.name << " " << share;
    met.insert(now.surface);
    return answer;
  }

  /// The change of stress is what the mean of the two tangents says. A kink
  /// between the ends adds up to half of what they differ by.
  bool is_explained(const double a,
                    const Response &at_a,
                    const double b,
                    const Response &at_b,
                    const unsigned halvings) const
  {
    constexpr double tolerance = 1e-8; // over the stress
    dealii::SymmetricTensor<2, 3> step;
    for (unsigned k = 0; k < 3; ++k)
      step[k][k] = (b - a) * (line_.end[k] - line_.start[k]);
    const auto by_a = at_a.tangent * step, by_b = at_b.tangent * step;
    const double off = (at_b.stress - at_a.stress - 0.5 * (by_a + by_b)).norm();
    if (off <= 0.5 * (by_b - by_a).norm() + tolerance * at_b.stress.norm())
      return true;
    if (halvings == 20) // the step changes the stress by less than 1e-8
      return false;
    std::set<Surface> met;
    const double middle = 0.5 * (a + b);
    const Response between = at(middle, met);
    return is_explained(a, at_a, middle, between, halvings + 1) &&
           is_explained(middle, between, b, at_b, halvings + 1);
  }

  const Line line_;
  const DruckerPragerCap law_;
  State old_ = law_.initial_state();
};

void expect_smooth(const DruckerPragerCapParameters &parameters,
                   const Line &line)
{
  Walk(parameters, line).expect_no_jump();
}

const std::vector<std::array<double, 3>> pressed{{0, 0, -0.5}};
const std::vector<std::array<double, 3>> unloaded{{0, 0, -0.5}, {0, 0, 0.03}};

TEST(CapContinuity, StressHasNoJumpWhilePressing)
{
  expect_smooth({},
                {"pressing",
                 0,
                 pressed,
                 {0, 0, 0},
                 {0, 0, -0.05},
                 {Surface::none, Surface::cap}});
}

TEST(CapContinuity, StressHasNoJumpInShearFailure)
{
  expect_smooth({},
                {"shear",
                 0,
                 unloaded,
                 {0, 0, 0},
                 {-0.02, 0.01, 0.04},
                 {Surface::none, Surface::shear}});
}

TEST(CapContinuity, StressHasNoJumpFromCapToShear)
{
  for (const double transition : {0., 0.02})
    expect_smooth(
        {},
        {"cap to shear",
         transition,
         pressed,
         {0, 0, -0.01},
         {0.015, 0.015, 0.},
         transition > 0
             ? std::set{Surface::cap, Surface::transition, Surface::shear}
             : std::set{Surface::cap, Surface::shear}});
}

TEST(CapContinuity, StressHasNoJumpThroughTheTransition)
{
  expect_smooth({},
                {"transition",
                 0.02,
                 {{0, 0, -0.3}, {0, 0, 0.02}, {-0.025, -0.025, 0.05}},
                 {0, 0, 0},
                 {-0.006, -0.004, 0.008},
                 {Surface::none, Surface::transition, Surface::cap}});
}

TEST(CapContinuity, StressHasNoJumpAtTheApex)
{
  expect_smooth({},
                {"apex",
                 0,
                 {{-0.2, -0.2, -0.2}},
                 {0., 0., 0.},
                 {0.03, 0.03, 0.03},
                 {Surface::none, Surface::apex}});
}

TEST(CapContinuity, StressHasNoJumpWithBoundedDilation)
{
  expect_smooth(agcusnin::parameters(),
                {"bounded",
                 0.02,
                 {{0, 0, -0.5}, {0, 0, 0.002}},
                 {0., -0.0005, -0.001},
                 {0.002, 0.0015, 0.002},
                 {Surface::none, Surface::shear}});
}
} // namespace
} // namespace tamp::fem
