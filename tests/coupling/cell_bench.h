// SPDX-License-Identifier: BSD-3-Clause
#ifndef tests_coupling_cell_bench_h
#define tests_coupling_cell_bench_h

#include <coupling/unit_cell_points.h>
#include <fem/build_mesh.h>
#include <fem/die_settings.h>
#include <fem/equilibrium.h>
#include <fem/tool_surface.h>

#include <gtest/gtest.h>
#include <utility>
#include <vector>

namespace tamp::coupling::test
{
/// A die of cells without a schedule: its upper punch goes where a test moves
/// it.
struct CellBench {
  fem::Mesh mesh;
  UnitCellPoints cells;
  fem::Press press;
  fem::Equilibrium equilibrium;

  CellBench(const fem::DieSettings &settings,
            std::vector<dem::UnitCell> packings,
            const CellPointsOptions &options)
      : mesh(fem::build_mesh(settings.geometry)),
        cells(std::move(packings), options),
        press(mesh,
              {fem::make_tools(settings.geometry, mesh), settings.friction},
              cells,
              settings.solver,
              fem::Ranks()),
        equilibrium(press, settings.solver, 0.2)
  {
  }

  /// An attempt to move the upper punch down by this length, of which the
  /// powder takes its share by its height.
  fem::Attempt attempt(double distance, fem::Equilibrium &with)
  {
    fem::Motion motion;
    motion[fem::upper_punch].displacement = -distance;
    const fem::NodePositions &places = press.compact().state().positions;
    const fem::Extent body = fem::extent(places);
    fem::Increment guess(fem::number_of_unknowns(mesh), 0.);
    for (std::size_t node = 0; node < places.size(); ++node)
      guess[mesh.axial_dof(node)] =
          -distance * (places[node][2] - body.low) / body.height();
    return with.attempt(motion, guess);
  }

  /// Moves the upper punch down and accepts; the attempt must succeed.
  fem::Attempt press_by(double distance)
  {
    const fem::Attempt result = attempt(distance, equilibrium);
    EXPECT_TRUE(result.converged) << result.reason;
    if (result.converged)
      equilibrium.accept();
    return result;
  }
};
} // namespace tamp::coupling::test

#endif
