// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_csv_reader_h
#define apps_input_csv_reader_h

#include <apps/input/units.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

namespace tamp::apps
{
/// Reads a table line by line: CSV with remarks after #, a header of names with
/// units, and values. Whatever is wrong throws InputError, "FILE:LINE: ...".
class CsvReader
{
public:
  /// A column of the header.
  struct Column {
    std::size_t number = 0;
    double factor = 0; ///< to SI
  };

  /// Reads up to the header.
  /// @param what  the kind of table, for the message if there is no such file
  CsvReader(const std::filesystem::path &file, const std::string &what);

  /// The remarks before the header, without #.
  const std::vector<std::string> &remarks() const { return remarks_; }
  /// The header as it stands; empty if there is none.
  const std::vector<std::string> &names() const { return names_; }

  /// The column "name[unit]"; none if there is no such name. Throws if the unit
  /// is not one of this dimension, or if there are two columns of the name.
  std::optional<Column> find(const std::string &name,
                             const Dimension &dimension) const;
  /// The same of a column that must be there. Throws if it is not.
  Column column(const std::string &name, const Dimension &dimension) const;

  /// Goes to the next line of values; false at the end. Throws if the line has
  /// not as many values as the header.
  bool next();

  /// The text of the line, and of its value in a column.
  const std::string &line() const { return text_; }
  const std::string &text(const Column &column) const
  {
    return fields_[column.number];
  }
  /// The value in a column, in SI. Throws if it is not a finite number.
  double number(const Column &column) const;
  /// All values of the line as they stand. Throws likewise.
  std::vector<double> numbers() const;

  /// Throws InputError with file and number of the line at hand.
  [[noreturn]] void complain(const std::string &problem) const;

private:
  bool read_line();

  std::filesystem::path file_;
  std::ifstream in_;
  unsigned line_ = 0;
  std::string text_;
  std::vector<std::string> remarks_, names_, fields_;
};
} // namespace tamp::apps

#endif
