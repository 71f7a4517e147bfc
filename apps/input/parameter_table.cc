// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/list_entry.h>
#include <apps/input/nearest_name.h>
#include <apps/input/parameter_entry.h>
#include <apps/input/parameter_file.h>
#include <apps/input/parameter_print.h>
#include <apps/input/parameter_table.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cassert>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>

namespace tamp::apps
{
namespace
{
using Section = std::vector<std::string>;

// Lets deal.II's ParameterHandler know what an entry accepts.
class Pattern final : public dealii::Patterns::PatternBase
{
public:
  explicit Pattern(EntryPattern pattern) : pattern_(std::move(pattern)) {}
  bool match(const std::string &value) const override
  {
    return pattern_.problem(value).empty();
  }
  std::string description(OutputStyle) const override
  {
    return fmt::format("[{}]", pattern_.expected());
  }
  std::unique_ptr<PatternBase> clone() const override
  {
    return std::make_unique<Pattern>(pattern_);
  }

private:
  EntryPattern pattern_;
};

std::string joined(const Section &section)
{
  return fmt::format("{}", fmt::join(section, "/"));
}

void with_section(dealii::ParameterHandler &handler,
                  const Section &section,
                  const auto &action)
{
  for (const std::string &name : section)
    handler.enter_subsection(name);
  action();
  for (std::size_t i = 0; i < section.size(); ++i)
    handler.leave_subsection();
}
} // namespace

struct ParameterTable::Implementation {
  dealii::ParameterHandler handler;
  std::vector<ParameterEntry> entries;
  Section section;

  void declare(const std::string &name,
               const std::string &value,
               const EntryPattern &pattern,
               const std::string &text)
  {
    assert(pattern.problem(value).empty());
    ParameterEntry entry{section, name, value, text, pattern, value, {}, {}};
    with_section(handler, section, [&] {
      handler.declare_entry(
          name, value, Pattern(pattern), entry.documentation());
    });
    entries.push_back(std::move(entry));
  }

  const ParameterEntry &at(const std::string &path) const
  {
    const auto entry = std::ranges::find_if(
        entries, [&](const auto &e) { return e.path() == path; });
    assert(entry != entries.end());
    return *entry;
  }

  // Names directly below a section: its subsections, or its entries.
  std::vector<std::string> below(const Section &outer, bool subsections) const
  {
    std::vector<std::string> names;
    for (const ParameterEntry &entry : entries) {
      const bool inside =
          entry.section.size() >= outer.size() &&
          std::equal(outer.begin(), outer.end(), entry.section.begin());
      if (!inside)
        continue;
      std::string name;
      if (subsections && entry.section.size() > outer.size())
        name = entry.section[outer.size()];
      else if (!subsections && entry.section.size() == outer.size())
        name = entry.name;
      if (!name.empty() && !std::ranges::count(names, name))
        names.push_back(name);
    }
    return names;
  }

  void check_section(const Assignment &assignment) const
  {
    Section outer;
    for (const std::string &name : assignment.section) {
      const auto known = below(outer, true);
      if (!std::ranges::count(known, name)) {
        const std::string where =
            outer.empty() ? "" : fmt::format(" in '{}'", joined(outer));
        const std::string nearest =
            known.empty() ? ""
                          : fmt::format("; did you mean '{}'?",
                                        nearest_name(name, known));
        throw InputError(fmt::format("{}: there is no section '{}'{}{}",
                                     assignment.source,
                                     name,
                                     where,
                                     nearest));
      }
      outer.push_back(name);
    }
  }

  [[noreturn]] void unknown(const Assignment &assignment) const
  {
    std::string hint;
    for (const ParameterEntry &entry : entries)
      if (entry.name == assignment.name)
        hint = fmt::format("; section '{}' has one", joined(entry.section));
    const auto names = below(assignment.section, false);
    if (hint.empty() && !names.empty())
      hint = fmt::format("; did you mean '{}'?",
                         nearest_name(assignment.name, names));
    throw InputError(
        assignment.section.empty()
            ? fmt::format("{}: there is no entry '{}' outside of a section{}",
                          assignment.source,
                          assignment.name,
                          hint)
            : fmt::format("{}: there is no entry '{}' in section '{}'{}",
                          assignment.source,
                          assignment.name,
                          joined(assignment.section),
                          hint));
  }

  void take(const Assignment &assignment)
  {
    check_section(assignment);
    if (assignment.name.empty())
      return;
    const auto entry = std::ranges::find_if(entries, [&](const auto &e) {
      return e.section == assignment.section && e.name == assignment.name;
    });
    if (entry == entries.end())
      unknown(assignment);
    const std::string value = assignment.number
                                  ? with_list_entry(*entry, assignment)
                                  : assignment.value;
    const std::string problem = entry->pattern.problem(value);
    if (!problem.empty())
      throw InputError(fmt::format(
          "{}: {} = {}: {}", assignment.source, entry->path(), value, problem));
    entry->value = value;
    entry->source = assignment.source;
    entry->folder = assignment.folder;
    with_section(
        handler, entry->section, [&] { handler.set(entry->name, value); });
  }
};

ParameterTable::ParameterTable()
    : implementation_(std::make_unique<Implementation>())
{
}
ParameterTable::~ParameterTable() = default;

void ParameterTable::enter(const std::string &section)
{
  implementation_->section.push_back(section);
}

void ParameterTable::leave()
{
  implementation_->section.pop_back();
}

void ParameterTable::quantity(const std::string &name,
                              const std::string &value,
                              const Dimension &dimension,
                              const Range &range,
                              const std::string &text)
{
  implementation_->declare(
      name, value, {EntryKind::quantity, dimension, range, {}}, text);
}

void ParameterTable::quantities(const std::string &name,
                                const std::string &value,
                                const Dimension &dimension,
                                const Range &range,
                                const std::string &text)
{
  implementation_->declare(
      name, value, {EntryKind::quantities, dimension, range, {}}, text);
}

void ParameterTable::integer(const std::string &name,
                             long value,
                             long minimum,
                             const std::string &text)
{
  Range range;
  range.minimum = static_cast<double>(minimum);
  implementation_->declare(
      name, std::to_string(value), {EntryKind::integer, {}, range, {}}, text);
}

void ParameterTable::integers(const std::string &name,
                              const std::string &value,
                              const std::string &text)
{
  implementation_->declare(
      name, value, {EntryKind::integers, {}, not_negative, {}}, text);
}

void ParameterTable::choice(const std::string &name,
                            const std::string &value,
                            const std::vector<std::string> &choices,
                            const std::string &text)
{
  implementation_->declare(
      name, value, {EntryKind::choice, {}, {}, choices}, text);
}

void ParameterTable::choices(const std::string &name,
                             const std::string &value,
                             const std::vector<std::string> &choices,
                             const std::string &text)
{
  implementation_->declare(
      name, value, {EntryKind::choices, {}, {}, choices}, text);
}

void ParameterTable::flag(const std::string &name,
                          bool value,
                          const std::string &text)
{
  implementation_->declare(
      name, value ? "true" : "false", {EntryKind::flag, {}, {}, {}}, text);
}

void ParameterTable::text(const std::string &name,
                          const std::string &value,
                          const std::string &text)
{
  implementation_->declare(name, value, {EntryKind::text, {}, {}, {}}, text);
}

void ParameterTable::read(const std::filesystem::path &file)
{
  const auto assignments =
      file.extension() == ".json" ? read_json(file) : read_prm(file);
  for (const Assignment &assignment : assignments)
    implementation_->take(assignment);
}

void ParameterTable::set(const std::string &assignment)
{
  implementation_->take(read_setting(assignment));
}

double ParameterTable::number(const std::string &path) const
{
  const auto [name, number] = numbered_name(path);
  if (number)
    return numbers(name).at(*number - 1);
  const ParameterEntry &entry = implementation_->at(path);
  return parse_quantity(entry.value, entry.pattern.dimension);
}

std::optional<std::size_t>
ParameterTable::list_size(const std::string &path) const
{
  for (const ParameterEntry &entry : implementation_->entries)
    if (entry.path() == path && is_list(entry))
      return split_list(entry.value).size();
  return {};
}

std::vector<double> ParameterTable::numbers(const std::string &path) const
{
  const ParameterEntry &entry = implementation_->at(path);
  return parse_quantities(entry.value, entry.pattern.dimension);
}

long ParameterTable::whole(const std::string &path) const
{
  return std::stol(implementation_->at(path).value);
}

std::vector<std::size_t> ParameterTable::indices(const std::string &path) const
{
  std::vector<std::size_t> result;
  for (const std::string &item : split_list(implementation_->at(path).value))
    result.push_back(std::stoul(item));
  return result;
}

std::string ParameterTable::word(const std::string &path) const
{
  return implementation_->at(path).value;
}

std::vector<std::string> ParameterTable::words(const std::string &path) const
{
  return split_list(implementation_->at(path).value);
}

bool ParameterTable::on(const std::string &path) const
{
  return implementation_->at(path).value == "true";
}

bool ParameterTable::given(const std::string &path) const
{
  return !implementation_->at(path).source.empty();
}

bool ParameterTable::given_below(const std::string &section) const
{
  return std::ranges::any_of(implementation_->entries, [&](const auto &entry) {
    return !entry.source.empty() && entry.section.front() == section;
  });
}

std::filesystem::path ParameterTable::folder(const std::string &path) const
{
  return implementation_->at(path).folder;
}

void ParameterTable::complain(const std::string &path,
                              const std::string &problem) const
{
  const ParameterEntry &entry = implementation_->at(path);
  throw InputError(fmt::format("{}: {} = {}: {}",
                               entry.source.empty() ? "default" : entry.source,
                               path,
                               entry.value,
                               problem));
}

void ParameterTable::print(std::ostream &out, TableFormat format) const
{
  switch (format) {
  case TableFormat::prm:
    implementation_->handler.print_parameters(
        out,
        dealii::ParameterHandler::PRM |
            dealii::ParameterHandler::KeepDeclarationOrder);
    break;
  case TableFormat::json:
    print_json(out, implementation_->entries);
    break;
  case TableFormat::md:
    print_markdown(out, implementation_->entries);
    break;
  }
}

void ParameterTable::echo(std::ostream &out) const
{
  print_in_si(out, implementation_->entries);
}
} // namespace tamp::apps
