// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_fem_die_bench_h
#define tests_fem_die_bench_h

#include <fem/build_mesh.h>
#include <fem/equilibrium.h>
#include <fem/laws/continuum_points.h>

#include <gtest/gtest.h>

namespace tamp::fem::test
{
/// A die without a schedule: its tools go where a test moves them.
template <class Law>
struct DieBench {
  Mesh mesh;
  ContinuumPoints<Law> points;
  Press press;
  Equilibrium equilibrium;

  DieBench(const DieSettings &settings, const Law &law)
      : mesh(build_mesh(settings.geometry)),
        points(law, mesh.number_of_points()),
        press(mesh,
              {make_tools(settings.geometry, mesh), settings.friction},
              points,
              settings.solver,
              Ranks()),
        equilibrium(press, settings.solver, 0.2)
  {
  }

  /// An attempt from rest, or from a powder that goes up by `shift` [m].
  Attempt attempt(const Motion &motion, double shift = 0)
  {
    Increment guess(number_of_unknowns(mesh), 0.);
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
      guess[mesh.axial_dof(node)] = shift;
    return equilibrium.attempt(motion, guess);
  }

  /// Moves the punches up by these lengths, the powder with the lower one, and
  /// accepts; the attempt must succeed.
  Attempt move(double upper, double lower)
  {
    Motion motion;
    motion[upper_punch].displacement = upper;
    motion[lower_punch].displacement = lower;
    const Attempt result = attempt(motion, lower);
    EXPECT_TRUE(result.converged) << result.reason;
    if (result.converged)
      equilibrium.accept();
    return result;
  }

  const ToolForces &forces() const { return press.forces(); }
  const NodePositions &positions() const
  {
    return press.compact().state().positions;
  }
  const std::vector<Response> &responses() const
  {
    return press.compact().state().responses;
  }
};
template <class Law>
DieBench(const DieSettings &, const Law &) -> DieBench<Law>;
} // namespace tamp::fem::test

#endif
