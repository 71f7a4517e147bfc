// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/parameter_print.h>

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace tamp::apps
{
namespace
{
using Section = std::vector<std::string>;
} // namespace

void print_json(std::ostream &out, std::span<const ParameterEntry> entries)
{
  nlohmann::ordered_json tree;
  for (const ParameterEntry &entry : entries) {
    nlohmann::ordered_json *node = &tree;
    for (const std::string &name : entry.section)
      node = &(*node)[name];
    (*node)[entry.name] = {{"value", entry.value},
                           {"default", entry.default_value},
                           {"unit", entry.pattern.unit()},
                           {"range", entry.pattern.limits()},
                           {"documentation", entry.text}};
  }
  out << tree.dump(2) << '\n';
}

void print_markdown(std::ostream &out, std::span<const ParameterEntry> entries)
{
  out << "# Parameters\n\nA value may carry a unit (`200 MPa`, `600 um`, `30 "
         "deg`); a bare number is SI.\n";
  Section section;
  for (const ParameterEntry &entry : entries) {
    if (entry.section != section) {
      section = entry.section;
      out << fmt::format("\n## {}\n\n| name | default | range | unit | meaning "
                         "|\n|---|---|---|---|---|\n",
                         fmt::join(section, " / "));
    }
    const EntryPattern &pattern = entry.pattern;
    out << fmt::format(
        "| {} | {} | {} | {} | {} |\n",
        entry.name,
        entry.default_value.empty() ? "(empty)"
                                    : fmt::format("`{}`", entry.default_value),
        pattern.limits().empty() ? pattern.expected() : pattern.limits(),
        pattern.unit().empty() ? "-" : pattern.unit(),
        entry.text);
  }
}

void print_in_si(std::ostream &out, std::span<const ParameterEntry> entries)
{
  Section section;
  const auto indent = [&] { return std::string(2 * section.size(), ' '); };
  const auto leave = [&] {
    section.pop_back();
    out << indent() << "end\n";
  };
  for (const ParameterEntry &entry : entries) {
    while (section.size() > entry.section.size() ||
           !std::equal(section.begin(), section.end(), entry.section.begin()))
      leave();
    while (section.size() < entry.section.size()) {
      out << indent() << "subsection " << entry.section[section.size()] << '\n';
      section.push_back(entry.section[section.size()]);
    }
    out << fmt::format("{}set {} = {}{}\n",
                       indent(),
                       entry.name,
                       entry.pattern.in_si(entry.value),
                       entry.pattern.unit().empty() ||
                               entry.pattern.unit() == "-"
                           ? ""
                           : fmt::format(" # [{}]", entry.pattern.unit()));
  }
  while (!section.empty())
    leave();
}
} // namespace tamp::apps
