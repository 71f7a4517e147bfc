// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input_table.h>
#include <apps/powder.h>
#include <apps/run_input.h>

namespace tamp::apps
{
void read_table(const RunOptions &options, ParameterTable &table)
{
  declare_parameters(table);
  table.read(options.input);
  for (const std::string &setting : options.settings)
    table.set(setting);
  take_powder(table);
}
} // namespace tamp::apps
