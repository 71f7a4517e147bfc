// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_input_table_h
#define apps_run_input_table_h

#include <apps/input/parameter_table.h>
#include <apps/run/run_session.h>

namespace tamp::apps
{
/// Fills an empty table with all parameters, the values of the input, those of
/// --set, which beat them, and those of the powder that they name. Throws
/// InputError.
void read_table(const RunOptions &options, ParameterTable &table);

/// Gives the files that parameters name by their full paths: what table.echo()
/// then prints can be read from any folder.
void name_files_in_full(ParameterTable &table);
} // namespace tamp::apps

#endif
