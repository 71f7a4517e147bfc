// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/list_entry.h>

#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tamp::apps
{
NumberedName numbered_name(const std::string &text)
{
  const std::size_t bracket = text.rfind('[');
  if (bracket == std::string::npos || text.back() != ']')
    return {text, {}};
  std::size_t number = 0;
  const char *const end = text.data() + text.size() - 1;
  const auto [rest, error] =
      std::from_chars(text.data() + bracket + 1, end, number);
  if (error != std::errc() || rest != end)
    return {text, {}};
  return {std::string(trimmed(text.substr(0, bracket))), number};
}

bool is_list(const ParameterEntry &parameter)
{
  return parameter.pattern.kind == EntryKind::quantities ||
         parameter.pattern.kind == EntryKind::integers;
}

std::string with_list_entry(const ParameterEntry &parameter,
                            const Assignment &one)
{
  const auto complain = [&](const std::string &problem) {
    throw InputError(fmt::format("{}: {}", one.source, problem));
  };
  if (!is_list(parameter))
    complain(fmt::format("{} is no list of numbers; expected it without [{}]",
                         parameter.path(),
                         *one.number));
  // In SI: a unit after the last entry would hold for others, too.
  std::vector<std::string> entries =
      split_list(parameter.pattern.in_si(parameter.value));
  if (entries.empty())
    complain(fmt::format("{} is empty; expected all of it to be given first",
                         parameter.path()));
  if (*one.number < 1 || *one.number > entries.size())
    complain(fmt::format("{} = {}: expected one of its entries, [1] to [{}]",
                         parameter.path(),
                         parameter.value,
                         entries.size()));
  EntryPattern pattern = parameter.pattern;
  pattern.kind = pattern.kind == EntryKind::quantities ? EntryKind::quantity
                                                       : EntryKind::integer;
  if (const std::string problem = pattern.problem(one.value); !problem.empty())
    complain(fmt::format(
        "{}[{}] = {}: {}", parameter.path(), *one.number, one.value, problem));
  entries[*one.number - 1] = pattern.in_si(one.value);
  return fmt::format("{}", fmt::join(entries, ", "));
}
} // namespace tamp::apps
