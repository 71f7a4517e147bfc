// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_parameter_print_h
#define apps_input_parameter_print_h

#include <apps/input/parameter_entry.h>

#include <iosfwd>
#include <span>

namespace tamp::apps
{
/// Prints values, defaults, units, ranges and texts as a JSON tree of sections.
void print_json(std::ostream &out, std::span<const ParameterEntry> entries);

/// Prints defaults, ranges, units and texts as one Markdown table a section.
void print_markdown(std::ostream &out, std::span<const ParameterEntry> entries);

/// Prints all values in SI, as an input file in the format of .prm.
void print_in_si(std::ostream &out, std::span<const ParameterEntry> entries);
} // namespace tamp::apps

#endif
