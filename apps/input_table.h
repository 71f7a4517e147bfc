// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_table_h
#define apps_input_table_h

#include <apps/parameter_table.h>
#include <apps/run_session.h>

namespace tamp::apps
{
/// Fills an empty table with all parameters, the values of the input, those of
/// --set, which beat them, and those of the powder that they name. Throws
/// InputError.
void read_table(const RunOptions &options, ParameterTable &table);
} // namespace tamp::apps

#endif
