// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_list_entry_h
#define apps_input_list_entry_h

#include <apps/input/parameter_entry.h>
#include <apps/input/parameter_file.h>

#include <cstddef>
#include <optional>
#include <string>

namespace tamp::apps
{
/// A name, and which entry of its list is meant, counted from 1: "Name[2]".
struct NumberedName {
  std::string name;
  std::optional<std::size_t> number; ///< none: the name has no number
};

NumberedName numbered_name(const std::string &text);

/// Whether a parameter is a list of numbers.
bool is_list(const ParameterEntry &parameter);

/// The list that a parameter has now with the entry that is assigned replaced,
/// in SI. Throws InputError if the parameter is no list of numbers, has no such
/// entry, or does not accept the value.
std::string with_list_entry(const ParameterEntry &parameter,
                            const Assignment &one);
} // namespace tamp::apps

#endif
