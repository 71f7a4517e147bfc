// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_nearest_name_h
#define apps_input_nearest_name_h

#include <string>
#include <string_view>
#include <vector>

namespace tamp::apps
{
/// The number of letters to change, insert, leave out or swap to turn one name
/// into another; capitals count as small letters.
/// Source: Damerau (1964), optimal string alignment.
std::size_t edit_distance(std::string_view first, std::string_view second);

/// The name closest to `name`, empty if there is none.
std::string nearest_name(std::string_view name,
                         const std::vector<std::string> &names);
} // namespace tamp::apps

#endif
