// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/list_entry.h>
#include <apps/input/parameter_file.h>
#include <apps/input/units.h>

#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace tamp::apps
{
namespace
{
using Assignments = std::vector<Assignment>;

std::ifstream open(const std::filesystem::path &file)
{
  std::ifstream in(file);
  if (!std::filesystem::is_regular_file(file) || !in)
    throw InputError(fmt::format("the input file '{}' cannot be read; expected "
                                 "a .prm or .json file",
                                 file.string()));
  return in;
}

// Takes `word` and the blanks after it off the front of a line.
bool accept(std::string_view &line, std::string_view word)
{
  if (!line.starts_with(word) ||
      (line.size() > word.size() && line[word.size()] != ' ' &&
       line[word.size()] != '\t'))
    return false;
  line = trimmed(line.substr(word.size()));
  return true;
}

class PrmReader
{
public:
  explicit PrmReader(Assignments &assignments) : assignments_(assignments) {}

  void read(const std::filesystem::path &file, unsigned depth)
  {
    std::ifstream in = open(file);
    if (depth > 20)
      throw InputError(
          fmt::format("{}: files include each other", file.string()));
    const std::size_t outer = section_.size();
    std::string physical, line;
    unsigned number = 0, first = 0;
    while (std::getline(in, physical)) {
      ++number;
      if (line.empty())
        first = number;
      std::string_view part = physical;
      part = trimmed(part.substr(0, part.find('#')));
      const bool continued = part.ends_with('\\');
      if (continued)
        part = trimmed(part.substr(0, part.size() - 1));
      if (!line.empty() && !part.empty())
        line += ' ';
      line += part;
      if (continued)
        continue;
      take(line, file, first, depth);
      line.clear();
    }
    if (section_.size() > outer)
      throw InputError(fmt::format(
          "{}: subsection '{}' has no 'end'", opened_.back(), section_.back()));
  }

private:
  void take(std::string_view line,
            const std::filesystem::path &file,
            unsigned number,
            unsigned depth)
  {
    const std::string source = fmt::format("{}:{}", file.string(), number);
    if (line.empty())
      return;
    if (accept(line, "subsection") || accept(line, "Subsection")) {
      section_.emplace_back(line);
      opened_.push_back(source);
      assignments_.push_back({section_, "", "", source, file.parent_path()});
    } else if (line == "end" || line == "END") {
      if (section_.empty())
        throw InputError(source + ": 'end' without a subsection");
      section_.pop_back();
      opened_.pop_back();
    } else if (accept(line, "set") || accept(line, "SET")) {
      const std::size_t equals = line.find('=');
      if (equals == std::string_view::npos)
        throw InputError(fmt::format("{}: 'set {}' has no '='; expected 'set "
                                     "Name = value'",
                                     source,
                                     line));
      assignments_.push_back({section_,
                              std::string(trimmed(line.substr(0, equals))),
                              std::string(trimmed(line.substr(equals + 1))),
                              source,
                              file.parent_path()});
    } else if (accept(line, "include")) {
      if (!std::filesystem::is_regular_file(file.parent_path() / line))
        throw InputError(fmt::format(
            "{}: the file '{}' to include is missing", source, line));
      read(file.parent_path() / line, depth + 1);
    } else
      throw InputError(fmt::format("{}: '{}' is not understood; expected "
                                   "'subsection Name', 'set Name = value', "
                                   "'end' or 'include FILE'",
                                   source,
                                   line));
  }

  Assignments &assignments_;
  std::vector<std::string> section_;
  std::vector<std::string> opened_;
};

std::string text_of(const nlohmann::json &value)
{
  if (value.is_string())
    return value.get<std::string>();
  if (value.is_array()) {
    std::string list;
    for (const auto &item : value)
      list += (list.empty() ? "" : ", ") + text_of(item);
    return list;
  }
  return value.dump();
}

void take(const nlohmann::json &object,
          const std::vector<std::string> &section,
          const std::filesystem::path &file,
          Assignments &assignments)
{
  for (const auto &[name, value] : object.items()) {
    Assignment assignment{section, name, "", file.string(), file.parent_path()};
    if (value.is_object() && !value.contains("value")) {
      auto inner = section;
      inner.push_back(name);
      assignments.push_back({inner, "", "", file.string(), file.parent_path()});
      take(value, inner, file, assignments);
      continue;
    }
    assignment.value = text_of(value.is_object() ? value["value"] : value);
    assignments.push_back(assignment);
  }
}
} // namespace

Assignments read_prm(const std::filesystem::path &file)
{
  Assignments assignments;
  PrmReader(assignments).read(file, 0);
  return assignments;
}

Assignments read_json(const std::filesystem::path &file)
{
  std::ifstream in = open(file);
  Assignments assignments;
  try {
    const auto tree = nlohmann::json::parse(in, nullptr, true, true);
    if (!tree.is_object())
      throw InputError(file.string() + ": expected an object of sections");
    take(tree, {}, file, assignments);
  } catch (const nlohmann::json::exception &error) {
    throw InputError(
        fmt::format("{}: this is not JSON: {}", file.string(), error.what()));
  }
  return assignments;
}
Assignment read_setting(const std::string &setting)
{
  const std::size_t equals = setting.find('=');
  Assignment read;
  read.source = fmt::format("--set \"{}\"", setting);
  if (equals == std::string::npos)
    throw InputError(read.source + ": expected \"Section/Name = value\"");
  std::string_view path = trimmed(std::string_view(setting).substr(0, equals));
  std::size_t slash;
  while ((slash = path.find('/')) != std::string_view::npos) {
    read.section.emplace_back(trimmed(path.substr(0, slash)));
    path.remove_prefix(slash + 1);
  }
  const NumberedName last = numbered_name(std::string(trimmed(path)));
  read.name = last.name;
  read.number = last.number;
  read.value = trimmed(std::string_view(setting).substr(equals + 1));
  return read;
}

} // namespace tamp::apps
