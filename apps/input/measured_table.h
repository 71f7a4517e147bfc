// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_measured_table_h
#define apps_input_measured_table_h

#include <apps/input/units.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tamp::apps
{
/// A table as test rigs and spreadsheets write it: lines that end in any way,
/// with or without a byte order mark; columns divided by semicolons, tabs or
/// commas; fields in quotes or not; decimal points, or decimal commas where
/// those do not divide columns. Blank lines and those that start with # are
/// passed over. The first line left is the header, "name[unit]" of each column.
class MeasuredTable
{
public:
  /// Throws InputError naming file and line if this is no such table.
  explicit MeasuredTable(const std::filesystem::path &file);

  std::size_t rows() const { return rows_.size(); }
  /// The line of the file that a row stands in.
  unsigned line(std::size_t row) const { return rows_[row].line; }
  unsigned header_line() const { return header_line_; }

  /// A column that was found.
  struct Column {
    std::size_t number = 0;
    std::string name;  ///< in small letters, words joined by underscores
    double factor = 1; ///< to SI
  };
  /// The column of this name; none if there is none. Throws InputError if there
  /// are two, or if it has no unit or one of another dimension.
  std::optional<Column> find(const std::string &name,
                             const Dimension &dimension) const;
  /// A value in SI. Throws InputError if it is no finite number.
  double value(std::size_t row, const Column &column) const;

  /// Throws InputError: "file:line: problem".
  [[noreturn]] void complain(unsigned line, const std::string &problem) const;

private:
  struct Row {
    unsigned line = 0;
    std::vector<std::string> fields;
  };

  void take_header(const std::string &text, unsigned line);
  void take_row(const std::string &text, unsigned line);
  void check_decimals(const Row &row);

  std::filesystem::path file_;
  char separator_ = ',';
  unsigned header_line_ = 0;
  std::vector<std::string> names_, units_; ///< without unit: empty
  std::vector<Row> rows_;
  unsigned comma_line_ = 0, point_line_ = 0; ///< first decimal ones, or 0
};
} // namespace tamp::apps

#endif
