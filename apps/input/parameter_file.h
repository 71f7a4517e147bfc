// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_parameter_file_h
#define apps_input_parameter_file_h

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tamp::apps
{
/// "set Name = value" with the sections around it.
struct Assignment {
  std::vector<std::string> section;
  std::string name; ///< empty: the line only enters the section
  std::string value;
  std::string source; ///< "file:line" or "--set ..."
  std::filesystem::path folder;
  /// Of the one entry of a list that is meant, counted from 1.
  std::optional<std::size_t> number = {};
};

/// Reads the lines of a .prm file (subsections, set, include, continuation and
/// comments as in deal.II's ParameterHandler). Throws InputError naming file
/// and line.
std::vector<Assignment> read_prm(const std::filesystem::path &file);

/// Reads "Section/Name = value" or "Section/Name[2] = value", as written after
/// --set. Throws InputError.
Assignment read_setting(const std::string &setting);

/// Reads a JSON file: objects are sections; a value is a text, a number, a
/// truth value, or an object with the member "value". Throws InputError.
std::vector<Assignment> read_json(const std::filesystem::path &file);
} // namespace tamp::apps

#endif
