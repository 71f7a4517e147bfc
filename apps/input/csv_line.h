// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_csv_line_h
#define apps_input_csv_line_h

#include <optional>
#include <string>
#include <vector>

namespace tamp::apps
{
/// What stands between the commas of a line, without blanks around it.
std::vector<std::string> fields_of(const std::string &line);

/// The finite number that is all of a field; none if it is not one.
std::optional<double> number_of(const std::string &field);
} // namespace tamp::apps

#endif
