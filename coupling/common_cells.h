// SPDX-License-Identifier: BSD-3-Clause
#ifndef coupling_common_cells_h
#define coupling_common_cells_h

#include <dem/deform.h>
#include <dem/tangent.h>
#include <dem/unit_cell.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tamp::coupling
{
/// A cell of grains, committed and under trial.
struct CommonCell {
  dem::UnitCell committed;
  dem::WarmGuess guess;

  dem::UnitCell trial;
  bool has_trial = false;
  dem::CellAnswer answer;            ///< of the trial
  std::optional<dem::Tangent> voigt; ///< of the trial, if asked for [Pa]
  std::string problem; ///< why the last trial failed; empty: it did not
  double cost = 0;     ///< of the last trial: force evaluations times grains

  std::size_t first_point = 0;
  /// Of which this is a copy, made since the last commit; none: of no other.
  std::optional<std::size_t> parent;

  /// A trial from the committed state. What goes wrong is told by the outcome
  /// or, for a stretch that is none or cannot be followed, by `problem` without
  /// a trial.
  /// @param stretch  with a number that is none: no stretch
  void press(const dem::Stretch &stretch,
             const dem::Driving &driving,
             bool warm,
             bool with_tangent);
  /// The trial becomes the committed state, if there is one.
  void commit();
};

/// The cells of points, each in common to points that began alike and were
/// told the same, to the last bit: they could not be told apart. They part, by
/// copying, in the trial in which they ask different stretches, and are one
/// again if the attempt at the step is given up.
class CommonCells
{
public:
  CommonCells() = default;
  /// @param cells    all different, or of no matter if they are not
  /// @param cell_of  the cell of each point
  CommonCells(std::vector<dem::UnitCell> cells,
              std::vector<std::size_t> cell_of);

  std::size_t points() const { return cell_of_.size(); }
  std::size_t cell_of(std::size_t point) const { return cell_of_.at(point); }
  const CommonCell &of(std::size_t point) const
  {
    return cells_[cell_of_.at(point)];
  }
  std::span<CommonCell> cells() { return cells_; }
  std::span<const CommonCell> cells() const { return cells_; }

  /// Points that ask different stretches of a cell part: the first one, and
  /// all that ask the same to the last bit, keep it. One stretch per point.
  void part(std::span<const dem::Stretch> stretches);
  /// All that parted since the last commit() are one again, without trials.
  void rejoin();
  void commit();

  /// Gives a point a committed cell of its own. It is to be followed by
  /// join_equal(), which drops the cell that the point had, too.
  void put(std::size_t point, dem::UnitCell cell);
  /// Cells that are equal to the last byte become one, without trials.
  void join_equal();
  /// Becomes the points `from` to `from + count` of the numbers until now;
  /// numbers that were none have no grains until put().
  void hold(std::ptrdiff_t from, std::size_t count);

private:
  void number_anew();

  std::vector<CommonCell> cells_;
  std::vector<std::size_t> cell_of_;
};
} // namespace tamp::coupling

#endif
