// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_planned_names_h
#define apps_planned_names_h

#include <string_view>

namespace tamp::apps
{
/// Whether a command is promised to users but not in this version.
bool is_planned_command(std::string_view name);
} // namespace tamp::apps

#endif
