// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_shared_cells_h
#define coupling_shared_cells_h

#include <coupling/unit_cell_points.h>
#include <dem/remarks.h>
#include <fem/shared_points.h>

#include <memory>
#include <span>
#include <vector>

namespace tamp::coupling
{
/// The remarks on the cell of a point.
struct PointRemarks {
  std::size_t point = 0;
  std::vector<dem::Remark> remarks;
};

/// A committed cell, in its own frame, and the rotation from there to the
/// die's.
struct TurnedCell {
  dem::UnitCell cell;
  dem::Matrix3 rotation;
};

/// The unit cells of a run, shared out over its ranks. All functions are
/// collective and answer the same on every rank.
class SharedCells final : public fem::SharedPoints
{
public:
  /// @param own    cells of this rank, see fem::SharedPoints.
  /// @param count  of all cells.
  SharedCells(std::unique_ptr<UnitCellPoints> own,
              std::size_t count,
              const fem::Ranks &ranks);

  /// See UnitCellPoints.
  void turn() { cells_.turn(); }
  void set_force_floor(double force) { cells_.set_force_floor(force); }

  /// Of all cells.
  CellReport report() const;
  /// How many of the committed cells differ, in any byte (by hashes of 64
  /// bits): the same on any number of ranks.
  std::size_t different_cells() const;
  /// A copy of a point's cell.
  TurnedCell cell(std::size_t point) const;
  /// What is doubtful about the committed cells, point by point.
  /// @param pressures  mean compressive stress of all points [Pa]
  std::vector<PointRemarks> judge(const dem::Driving &driving,
                                  std::span<const double> pressures) const;

private:
  SharedCells(UnitCellPoints *own, std::size_t count, const fem::Ranks &ranks);

  UnitCellPoints &cells_; ///< of this rank; the base owns them
};
} // namespace tamp::coupling

#endif
