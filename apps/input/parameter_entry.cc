// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/nearest_name.h>
#include <apps/input/parameter_entry.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tamp::apps
{
namespace
{
bool parse_whole(const std::string &text, long &value)
{
  const std::string_view word = trimmed(text);
  const auto [rest, error] =
      std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && rest == word.data() + word.size();
}

std::string quoted_list(const std::vector<std::string> &names)
{
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string one_of(const std::vector<std::string> &names,
                   const std::string &value)
{
  const std::string nearest = nearest_name(value, names);
  return fmt::format("'{}' is not available; expected one of: {} (nearest: "
                     "'{}')",
                     value,
                     quoted_list(names),
                     nearest);
}
} // namespace

bool Range::contains(double value) const
{
  return (without_minimum ? value > minimum : value >= minimum) &&
         (without_maximum ? value < maximum : value <= maximum);
}

std::vector<std::string> split_list(const std::string &list)
{
  std::vector<std::string> items;
  if (trimmed(list).empty())
    return items;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = list.find(',', begin);
    items.emplace_back(
        trimmed(std::string_view(list).substr(begin, end - begin)));
    if (end == std::string::npos)
      return items;
    begin = end + 1;
  }
}

std::vector<double> parse_quantities(const std::string &list,
                                     const Dimension &dimension)
{
  const std::vector<std::string> items = split_list(list);
  std::vector<double> values;
  double common_factor = 1;
  if (!items.empty()) {
    const std::size_t unit = items.back().find_first_of(" \t");
    if (unit != std::string::npos)
      if (const auto factor = parse_unit(items.back().substr(unit)))
        common_factor = factor->value;
  }
  for (const std::string &item : items) {
    const double value = parse_quantity(item, dimension);
    const bool bare = !parse_quantity(item).dimension.has_value();
    values.push_back(bare ? value * common_factor : value);
  }
  return values;
}

std::string EntryPattern::unit() const
{
  switch (kind) {
  case EntryKind::quantity:
  case EntryKind::quantities:
    return si_unit(dimension);
  case EntryKind::integer:
  case EntryKind::integers:
    return "-";
  default:
    return {};
  }
}

std::string EntryPattern::limits() const
{
  if (kind == EntryKind::choice)
    return "one of " + quoted_list(names);
  if (kind == EntryKind::choices)
    return "any of " + quoted_list(names);
  if (kind == EntryKind::flag)
    return "true or false";
  std::string limits;
  if (std::isfinite(range.minimum))
    limits =
        fmt::format("{} {}", range.without_minimum ? ">" : ">=", range.minimum);
  if (std::isfinite(range.maximum))
    limits += fmt::format("{}{} {}",
                          limits.empty() ? "" : " and ",
                          range.without_maximum ? "<" : "<=",
                          range.maximum);
  return limits;
}

std::string EntryPattern::expected() const
{
  const std::string bounds =
      limits().empty() ? "" : fmt::format(" {}", limits());
  switch (kind) {
  case EntryKind::quantity:
  case EntryKind::quantities: {
    std::string what = described(dimension);
    const std::size_t comma = what.find(',');
    if (comma == std::string::npos)
      return what + bounds;
    return what.substr(0, comma) + bounds +
           (unit() == "-" ? "" : fmt::format(" [{}]", unit())) +
           what.substr(comma) +
           (kind == EntryKind::quantities ? "; several are divided by commas"
                                          : "");
  }
  case EntryKind::integer:
    return "a whole number" + bounds;
  case EntryKind::integers:
    return "whole numbers >= 0, divided by commas";
  case EntryKind::flag:
    return "true or false";
  default:
    return limits().empty() ? "a text" : limits();
  }
}

std::string EntryPattern::problem(const std::string &value) const
{
  try {
    switch (kind) {
    case EntryKind::quantity:
    case EntryKind::quantities: {
      if (kind == EntryKind::quantity && trimmed(value).empty())
        return "it is empty; expected " + expected();
      const std::vector<double> values =
          kind == EntryKind::quantity
              ? std::vector<double>{parse_quantity(value, dimension)}
              : parse_quantities(value, dimension);
      for (const double number : values)
        if (!range.contains(number))
          return fmt::format(
              "{} is out of range; expected {}", number, expected());
      return {};
    }
    case EntryKind::integer: {
      long number = 0;
      if (!parse_whole(value, number))
        return fmt::format("expected {}", expected());
      if (!range.contains(static_cast<double>(number)))
        return fmt::format(
            "{} is out of range; expected {}", number, expected());
      return {};
    }
    case EntryKind::integers:
      for (const std::string &item : split_list(value)) {
        long number = 0;
        if (!parse_whole(item, number) || number < 0)
          return fmt::format(
              "'{}' does not fit; expected {}", item, expected());
      }
      return {};
    case EntryKind::flag:
      return value == "true" || value == "false" ? ""
                                                 : "expected true or false";
    case EntryKind::choice:
      return std::ranges::count(names, value) ? "" : one_of(names, value);
    case EntryKind::choices:
      for (const std::string &item : split_list(value))
        if (!std::ranges::count(names, item))
          return one_of(names, item);
      return {};
    case EntryKind::text:
      return {};
    }
  } catch (const InputError &error) {
    return fmt::format("{}; expected {}", error.what(), expected());
  }
  return {};
}

std::string EntryPattern::in_si(const std::string &value) const
{
  if (kind == EntryKind::quantity)
    return fmt::format("{}", parse_quantity(value, dimension));
  if (kind == EntryKind::quantities)
    return fmt::format("{}",
                       fmt::join(parse_quantities(value, dimension), ", "));
  return value;
}

std::string ParameterEntry::path() const
{
  return fmt::format("{}/{}", fmt::join(section, "/"), name);
}

std::string ParameterEntry::documentation() const
{
  std::string result = text;
  if (!pattern.limits().empty())
    result += (result.ends_with('.') ? " " : "; ") + pattern.limits();
  if (!pattern.unit().empty())
    result += fmt::format(" [{}]", pattern.unit());
  return result;
}
} // namespace tamp::apps
