// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_csv_line_h
#define apps_input_csv_line_h

#include <apps/input/units.h>

#include <optional>
#include <string>
#include <vector>

namespace tamp::apps
{
/// What stands between the commas of a line, without blanks around it.
std::vector<std::string> fields_of(const std::string &line);

/// The finite number that is all of a field; none if it is not one.
std::optional<double> number_of(const std::string &field);

/// The factor to SI of a column "name[unit]"; none if it has another name.
/// Throws InputError if the unit is not one of this dimension.
std::optional<double> column_factor(const std::string &column,
                                    const std::string &name,
                                    const Dimension &dimension);
} // namespace tamp::apps

#endif
