// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_unit_cell_points_h
#define coupling_unit_cell_points_h

#include <coupling/common_cells.h>
#include <dem/deform.h>
#include <dem/unit_cell.h>
#include <fem/movable_points.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tamp::coupling
{
/// What the step since the last commit() cost, and how good the answers of the
/// last evaluate() are. Stays readable after commit().
struct CellReport {
  /// Of forces, whole step: what the cell of each point took, for all points.
  std::uint64_t evaluations = 0;
  /// The same for all cells: those of a cell that points share count once.
  std::uint64_t done_evaluations = 0;
  std::size_t points = 0, cells = 0;
  double worst_unbalance = 0; ///< largest unbalance of a cell [-]
  std::size_t worst_unbalance_point = 0;
  double worst_hill_mandel = 0; ///< largest residual of a cell [-]
  double worst_asymmetry = 0;   ///< largest |skw stress| / |stress| [-]
  std::size_t unsettled = 0;    ///< cells that ran into the cap
  std::string problem;          ///< of the first point that failed

  /// Force evaluations of the cell of a point in the whole step.
  double mean_evaluations() const
  {
    return static_cast<double>(evaluations) /
           static_cast<double>(points > 0 ? points : 1);
  }
};

/// How cells are driven and shared among threads.
struct CellPointsOptions {
  dem::Driving driving;
  unsigned threads = 1;
  /// Use the last trial of the same step as a start of the relaxation. Off: an
  /// evaluation is a pure function of the committed states.
  bool warm = true;
  /// Number of the first point among those of the run.
  std::size_t first_point = 0;
};

/// Grains as material points: each point has a committed and a trial unit cell,
/// in common with the points of the same history, if there are any. Rotation is
/// split off and costs no sweep: with F = R U the cell, in its own frame Q,
/// feels Q^T U Q, and the stress is turned back by R Q. The tangent is the
/// Voigt contact tangent times the secant of the last committed step. The
/// answer of a point depends on its own history only, not on threads.
class UnitCellPoints final : public fem::MovablePoints
{
public:
  /// A cell for each point.
  UnitCellPoints(std::vector<dem::UnitCell> cells,
                 const CellPointsOptions &options);
  /// @param cell_of  the cell of each point
  UnitCellPoints(std::vector<dem::UnitCell> cells,
                 std::vector<std::size_t> cell_of,
                 const CellPointsOptions &options);
  ~UnitCellPoints() override;

  std::size_t size() const override;
  void begin_attempt() override;
  void evaluate(std::span<const fem::Deformation> deformations,
                fem::Want want,
                std::span<fem::Response> responses) override;
  void commit() override;
  void pack(std::size_t point, std::vector<char> &bytes) const override;
  void unpack(std::size_t point, std::span<const char> bytes) override;
  /// Force evaluations times grains: the same on every machine.
  double cost(std::size_t point) const override;
  std::vector<fem::Variable> variables() const override;
  void variables_of(std::size_t point, std::span<double> values) const override;
  fem::Share share() const override;
  void hold(const fem::Share &share) override;

  /// Forgets extrapolations, secants and predictors: call when the direction
  /// of loading turns.
  void turn();
  /// Contact forces below this count as this in the unbalance [N].
  void set_force_floor(double force);

  /// Points are called there by their numbers among those of the run.
  const CellReport &report() const;
  /// The committed cell of a point, in its own frame.
  const dem::UnitCell &cell(std::size_t point) const;
  /// The rotation from the frame of a point's cell to the die's.
  dem::Matrix3 rotation(std::size_t point) const;

private:
  struct Point;
  dem::Stretch split(Point &point, const fem::Deformation &deformation) const;
  void press(std::span<const dem::Stretch> stretches, fem::Want want);
  void
  respond(Point &point, const CommonCell &cell, fem::Response &response) const;
  void summarise(std::span<const fem::Response> responses);

  std::vector<Point> points_;
  CellPointsOptions options_;
  CommonCells cells_;
  CellReport report_;
  bool step_begins_ = true, attempted_ = false;
  bool unpacked_ = true; ///< cells may be equal and not yet in common
};
} // namespace tamp::coupling

#endif
