// SPDX-License-Identifier: BSD-3-Clause
#include <apps/planned_names.h>

#include <algorithm>
#include <array>

namespace tamp::apps
{
namespace
{
constexpr std::array<std::string_view, 3> commands{
    "calibrate", "compare", "selftest"};
} // namespace

bool is_planned_command(std::string_view name)
{
  return std::ranges::count(commands, name) > 0;
}
} // namespace tamp::apps
