// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_die_die_cells_h
#define apps_die_die_cells_h

#include <apps/die/cell_bias.h>
#include <apps/die/die_results.h>
#include <apps/die/recorded_points.h>
#include <apps/run/cell_remarks.h>
#include <apps/run/run_session.h>
#include <coupling/shared_cells.h>
#include <fem/die_model.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tamp::apps
{
/// The material points of a die on this rank.
struct DieMaterial {
  std::unique_ptr<fem::MaterialPoints> points;
  /// The same object, which then stands for the points of all ranks; null for
  /// continua.
  coupling::SharedCells *cells = nullptr;
  /// That share finite elements: each for itself if the points are all cells.
  fem::Ranks model_ranks;

  /// The points that this rank computes: all of a checkpoint that is its part.
  fem::MaterialPoints &own() { return cells ? cells->own() : *points; }
};

/// Makes the points of a die: unit cells are shared out by number, other points
/// with the elements they belong to. Throws the same on all ranks.
DieMaterial make_die_material(RunSession &session, const fem::Ranks &ranks);

/// What a die run has to do with its unit cells besides pressing them; nothing
/// if it has none.
class DieCells
{
public:
  /// @param cells  null for continua. All must outlive this.
  DieCells(RunSession &session,
           const fem::DieModel &model,
           RecordedPoints &points,
           coupling::SharedCells *cells);

  /// The direction of loading turns: what cells learnt of it is of no use, and
  /// forces that are small against those of the peak need no perfect balance.
  /// @param peak_pressure  so far [Pa]
  void begin_stage(fem::StageKind kind, double peak_pressure);
  /// Adds what the last step cost and how good its answers are. Collective.
  void measure(StepEffort &effort);
  /// Says what is doubtful about the cells. Collective.
  /// @param step  and what was done in it, in words.
  void judge(const std::string &step);
  /// Why the last evaluation failed; empty if it is not known. Collective.
  std::string problem() const;
  /// The run has come to its end. Collective.
  void end();
  /// Hands the key results to the session.
  void give() const;

  /// Appends what a step leaves but for the cells; go_on() takes it up.
  void pack(std::vector<char> &bytes) const;
  void go_on(fem::StateBytes &stored);

private:
  std::string place(std::size_t point, const std::string &step) const;

  RunSession &session_;
  const fem::DieModel &model_;
  RecordedPoints &points_;
  coupling::SharedCells *cells_;
  CellRemarks remarks_;
  CellBias bias_;
  double force_floor_ = 0;    ///< of the stage [N]
  std::size_t different_ = 0; ///< cells, at the end of the run
};
} // namespace tamp::apps

#endif
