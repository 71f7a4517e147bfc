// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_parameter_entry_h
#define apps_input_parameter_entry_h

#include <apps/input/parameter_table.h>

#include <string>
#include <vector>

namespace tamp::apps
{
enum class EntryKind {
  quantity,
  quantities,
  integer,
  integers,
  choice,
  choices,
  flag,
  text
};

/// What values an entry accepts.
struct EntryPattern {
  EntryKind kind = EntryKind::text;
  Dimension dimension;
  Range range;
  std::vector<std::string> names;

  /// Empty if the entry accepts `value`, otherwise what is wrong with it and
  /// what was expected.
  std::string problem(const std::string &value) const;
  /// "a pressure > 0 [Pa], for example 200 MPa".
  std::string expected() const;
  /// "> 0" or "one of hertz, thornton-ning"; empty if anything is accepted.
  std::string limits() const;
  /// "Pa", "-"; empty for words.
  std::string unit() const;
  /// The value in SI with all digits.
  std::string in_si(const std::string &value) const;
};

/// A parameter with the value it has now.
struct ParameterEntry {
  std::vector<std::string> section;
  std::string name;
  std::string default_value;
  std::string text;
  EntryPattern pattern;
  std::string value;
  std::string source;           ///< "file:line", "--set"; empty for the default
  std::filesystem::path folder; ///< of the file

  /// "Section/Name".
  std::string path() const;
  /// The text with limits and unit, as in printed tables.
  std::string documentation() const;
};

/// Divides "a, b, c".
std::vector<std::string> split_list(const std::string &list);
/// Reads quantities divided by commas; a unit after the last one holds for all
/// that have none.
std::vector<double> parse_quantities(const std::string &list,
                                     const Dimension &dimension);
} // namespace tamp::apps

#endif
