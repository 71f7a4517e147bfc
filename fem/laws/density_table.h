// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_density_table_h
#define fem_laws_density_table_h

#include <string>
#include <vector>

namespace tamp::fem
{
/// The rows of a table as they stand in a file.
struct TableRows {
  std::vector<double> x; ///< relative density or plastic volumetric strain [-]
  std::vector<double> y; ///< the tabulated property, in its SI unit
};

/// A property that depends on relative density or on plastic volumetric strain,
/// given by rows that are joined by straight lines. Between two rows the
/// value stays between theirs, so a monotone table gives a monotone property.
/// A table may also be one constant, which holds everywhere.
class DensityTable
{
public:
  /// What the rows have to be.
  enum class Shape { any, increasing };
  /// What holds above the last row. Below the first row its value holds.
  enum class Above { hold, extend };

  /// What a table says at a place.
  struct Reading {
    double value = 0;     ///< [unit of y]
    double slope = 0;     ///< d value / d x; zero where a value is held
    bool outside = false; ///< beyond the rows: the value is a guess
  };

  /// The straight line that holds for low <= x < high.
  struct Line {
    double low = 1, high = 0;
    double place = 0, value = 0, slope = 0;

    bool holds(double x) const { return x >= low && x < high; }
    double at(double x) const { return value + slope * (x - place); }
  };

  /// A constant. It is never outside.
  DensityTable(double constant);

  /// Throws std::invalid_argument naming the table, the row and what was
  /// expected unless there are at least two rows of finite numbers, x
  /// increases strictly, and y increases weakly where `shape` asks for it.
  /// @param name   appears in messages, "cohesion" for example.
  /// @param above  extend: the last line goes on; hold: the last value holds.
  DensityTable(TableRows rows,
               const std::string &name,
               Shape shape = Shape::any,
               Above above = Above::hold);

  /// The value at x. A place within 1e-9 beyond a row counts as inside.
  Reading read(double x) const;

  /// The line that holds at x: its value and slope are those of read(). Whoever
  /// reads often keeps it as long as it holds.
  Line line(double x) const;

  /// As given; a constant has one row at 0.
  const TableRows &rows() const { return rows_; }
  /// The first and last place; minus and plus infinity for a constant.
  double first_place() const;
  double last_place() const;
  double smallest() const; ///< over the rows [unit of y]
  double largest() const;  ///< over the rows [unit of y]
  /// No value is below that of the row before.
  bool is_increasing() const;

private:
  TableRows rows_;
  Above above_ = Above::hold;
};
} // namespace tamp::fem

#endif
