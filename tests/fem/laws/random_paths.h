// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_fem_laws_random_paths_h
#define tests_fem_laws_random_paths_h

#include <fem/laws/continuum_points.h>

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace tamp::fem::test
{
/// Increments in all directions, mostly compression: two paths of three drift.
struct RandomPaths {
  unsigned paths = 80, increments = 50; ///< of each path
  double exponent = -2.5; ///< strains are of 10^(exponent +- 1.2) / 3
  double drift = 0.6;     ///< towards compression, over the size
};

/// Takes a point along random paths, each from its state now: no increment
/// fails, and all that is answered is finite. Calls check() after each.
template <class Points, class Check>
void follow_random_paths(Points &points,
                         const RandomPaths &chosen,
                         const Check &check)
{
  std::mt19937 random(20240517);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<char> fresh;
  points.pack(0, fresh);
  std::vector<Response> answer(1);
  for (unsigned step = 0; step < chosen.paths * chosen.increments; ++step) {
    if (step % chosen.increments == 0)
      points.unpack(0, fresh);
    const double size =
        std::pow(10, chosen.exponent + 1.2 * uniform(random)) / 3;
    const double drift = step / chosen.increments % 3 == 0 ? 0 : -chosen.drift;
    dealii::Tensor<2, 3> F(dealii::unit_symmetric_tensor<3>());
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = 0; j < 3; ++j)
        F[i][j] += size * (uniform(random) + (i == j ? drift : 0));
    points.evaluate(
        std::vector<Deformation>(1, {F}), Want::stress_and_tangent, answer);
    ASSERT_NE(answer[0].status, Status::failed) << "step " << step;
    ASSERT_TRUE(std::isfinite(answer[0].stress.norm())) << "step " << step;
    ASSERT_TRUE(std::isfinite(answer[0].tangent.norm())) << "step " << step;
    points.commit();
    check();
    ASSERT_FALSE(testing::Test::HasFailure()) << "step " << step;
  }
}
} // namespace tamp::fem::test

#endif
