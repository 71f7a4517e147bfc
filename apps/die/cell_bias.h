// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_cell_bias_h
#define apps_die_cell_bias_h

#include <apps/die/recorded_points.h>
#include <apps/run/run_session.h>
#include <coupling/bias_sampling.h>

#include <cstdint>
#include <span>
#include <vector>

namespace tamp::apps
{
/// What the cells of a run are off by: the change of the stress of a few if
/// they are driven more finely, over it or, if that is larger, the mean of all.
/// The run goes on as if nobody had looked. All functions but give() and pack()
/// are collective.
class CellBias
{
public:
  /// @param cells  null for continua: nothing is sampled. All must outlive
  /// this.
  CellBias(RunSession &session, coupling::SharedCells *cells);

  /// Looks at a step that is about to be committed, if it is its turn.
  /// @param step         its number, from 1
  /// @param force_floor  of the cells [N]
  void look(unsigned step,
            std::span<const fem::Deformation> deformations,
            std::span<const PointAnswer> answers,
            double force_floor);
  /// Adds the force evaluations that the run itself took for a step, of all
  /// cells.
  void add_cost(double evaluations) { tally_.run_evaluations += evaluations; }
  /// Hands the results to the session, with a warning if equilibrium is sought
  /// more exactly than cells answer.
  /// @param force_tolerance  of the run [-]
  void give(double force_tolerance) const;

  /// Appends what was found so far; go_on() takes it up.
  void pack(std::vector<char> &bytes) const;
  void go_on(fem::StateBytes &stored);

private:
  /// Sums over all samples so far.
  struct Tally {
    std::uint64_t samples = 0;
    std::uint64_t unsettled = 0; ///< driven more finely, and not counted
    double bias = 0;             ///< sum [-]
    double worst = 0;
    double evaluations = 0;     ///< of forces, by sampling
    double run_evaluations = 0; ///< and by the run
  };

  RunSession &session_;
  coupling::SharedCells *cells_;
  Tally tally_;
};
} // namespace tamp::apps

#endif
