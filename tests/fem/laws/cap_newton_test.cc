// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/drucker_prager_cap.h>

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>
#include <vector>

namespace tamp::fem
{
namespace
{
using dealii::Tensor;
using Surface = DruckerPragerCap::Surface;
using State = DruckerPragerCap::State;

Tensor<2, 3> stretch(const double xx, const double yy, const double zz)
{
  Tensor<2, 3> F;
  F[0][0] = std::exp(xx);
  F[1][1] = std::exp(yy);
  F[2][2] = std::exp(zz);
  return F;
}

/// Equal increments.
struct Leg {
  Tensor<2, 3> F;
  unsigned count;
};

/// The state after some legs.
State driven(const DruckerPragerCap &law, const std::vector<Leg> &path)
{
  auto old = law.initial_state(), now = old;
  for (const Leg &leg : path)
    for (unsigned i = 0; i < leg.count; ++i) {
      EXPECT_EQ(law.respond(old, now, {leg.F}, Want::stress).status,
                Status::converged);
      old = now;
    }
  return old;
}

/// Finds the lateral strain at which the lateral stress is the wanted one, for
/// a given axial strain, by Newton's method; says the stresses that are left.
std::vector<double> residuals_of_newton(const DruckerPragerCap &law,
                                        const State &old,
                                        const double axial,
                                        const double wanted,
                                        const Surface surface)
{
  double lateral = 0;
  std::vector<double> residuals;
  auto now = old;
  for (unsigned i = 0; i < 8; ++i) {
    const auto answer = law.respond(
        old, now, {stretch(lateral, lateral, axial)}, Want::stress_and_tangent);
    EXPECT_EQ(answer.status, Status::converged);
    const double residual = answer.stress[0][0] - wanted;
    residuals.push_back(std::abs(residual) / std::abs(old.stress[2][2]));
    lateral -=
        residual / (answer.tangent[0][0][0][0] + answer.tangent[0][0][1][1]);
  }
  EXPECT_EQ(now.surface, surface);
  return residuals;
}

/// The last slope of log residuals that is not round-off.
double order(const std::vector<double> &residuals)
{
  constexpr double round_off = 1e-12;
  double slope = 0;
  for (std::size_t i = 2; i < residuals.size() && residuals[i] > round_off; ++i)
    slope = std::log(residuals[i] / residuals[i - 1]) /
            std::log(residuals[i - 1] / residuals[i - 2]);
  std::cout << "residuals of Newton's method:";
  for (const double residual : residuals)
    std::cout << ' ' << residual;
  std::cout << ", order " << slope << '\n';
  EXPECT_LT(residuals.back(), round_off);
  return slope;
}

TEST(CapNewton, UniaxialStressConvergesQuadraticallyOnTheCap)
{
  const DruckerPragerCap law;
  const State old = driven(law, {{stretch(-2e-3, -2e-3, -2e-3), 150}});
  // Lateral stress kept, axial compaction.
  const auto residuals =
      residuals_of_newton(law, old, -1e-2, old.stress[0][0], Surface::cap);
  EXPECT_NEAR(order(residuals), 2, 0.2);
}

TEST(CapNewton, UniaxialStressConvergesQuadraticallyOnShear)
{
  const DruckerPragerCap law;
  const State old = driven(law, {{stretch(0, 0, -5e-3), 100}});
  // The die taken off: almost free of lateral stress, pressed along z.
  const auto residuals = residuals_of_newton(
      law, old, -4e-3, 0.02 * old.stress[0][0], Surface::shear);
  EXPECT_NEAR(order(residuals), 2, 0.2);
}

struct Probe {
  double transition;
  std::vector<Leg> path;
  Tensor<2, 3> next;
  Surface surface;
};

/// Largest error of the tangent against central differences, over its norm.
double tangent_error(const Probe &probe)
{
  DruckerPragerCapParameters parameters;
  parameters.transition = probe.transition;
  const DruckerPragerCap law(parameters);
  const State old = driven(law, probe.path);
  auto now = old;
  const auto answer =
      law.respond(old, now, {probe.next}, Want::stress_and_tangent);
  EXPECT_EQ(answer.status, Status::converged);
  EXPECT_EQ(now.surface, probe.surface);
  double worst = 0;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = i; j < 3; ++j) {
      const double h = 1e-6;
      Tensor<2, 3> strain;
      strain[i][j] += h / 2;
      strain[j][i] += h / 2;
      const Tensor<2, 3> one(dealii::unit_symmetric_tensor<3>());
      const auto ahead =
          law.respond(old, now, {(one + strain) * probe.next}, Want::stress);
      const auto behind =
          law.respond(old, now, {(one - strain) * probe.next}, Want::stress);
      const auto slope = (ahead.stress - behind.stress) / (2 * h);
      const auto column = answer.tangent * symmetrize(strain) / h;
      worst = std::max(worst, (column - slope).norm());
    }
  return worst / answer.tangent.norm();
}

Tensor<2, 3> with_shear(Tensor<2, 3> F, const double xy, const double zx)
{
  F[0][1] += xy;
  F[2][0] += zx;
  return F;
}

TEST(CapNewton, TangentIsTheSlopeOnEverySurface)
{
  const Leg press{with_shear(stretch(0, 0, -5e-3), 5e-4, 1e-3), 60};
  const Leg unload{stretch(0, 0, 1e-3), 20};
  const Leg shear{stretch(-5e-4, -5e-4, 1e-3), 45};
  const auto slanted = with_shear(stretch(-1e-3, 0, -6e-3), -2e-3, 3e-3);
  const auto back = with_shear(stretch(3e-3, 1e-3, 5e-3), 4e-3, -4e-3);
  const auto sheared = with_shear(stretch(-5e-4, -4e-4, 1e-3), 5e-4, -1e-3);
  for (const auto &probe : std::vector<Probe>{
           {0, {press}, stretch(1e-5, 0, 5e-5), Surface::none},
           {0, {press}, slanted, Surface::cap},
           {0.02, {press, press}, slanted, Surface::cap},
           {0, {press, unload, unload}, back, Surface::shear},
           {0.02, {press, unload, shear}, sheared, Surface::transition}})
    // Central differences: h^2 times curvature and round-off over h.
    EXPECT_LT(tangent_error(probe), 1e-6) << static_cast<int>(probe.surface);
}
} // namespace
} // namespace tamp::fem
