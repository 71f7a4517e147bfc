// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_input_purpose_h
#define apps_input_input_purpose_h

#include <apps/input/parameter_table.h>
#include <apps/input/run_input.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// The commands that an input is for, judged by the sections that it gives; at
/// least one: `die`, `probe`, `contact` or `pack`.
std::vector<Need> purposes(const ParameterTable &table);

/// The name of the command that reads an input for this need; empty if it is no
/// single one.
std::string name_of(Need need);
} // namespace tamp::apps

#endif
