// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_value_checks_h
#define apps_input_value_checks_h

#include <functional>
#include <string>
#include <vector>

namespace tamp::apps
{
class ParameterTable;

/// Runs a check of values that were read from the entries `paths`. If it throws
/// std::invalid_argument, throws InputError about the entry whose name its
/// message says (the longest name, in any case of letters), or about the first
/// one. InputError passes as it is.
void check_values(const ParameterTable &table,
                  const std::vector<std::string> &paths,
                  const std::function<void()> &check);
} // namespace tamp::apps

#endif
