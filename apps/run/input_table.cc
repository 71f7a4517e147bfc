// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/powder.h>
#include <apps/input/run_input.h>
#include <apps/run/input_table.h>

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

void name_files_in_full(ParameterTable &table)
{
  for (const std::string path : {"Die/Initial density file",
                                 "Die/Mesh file",
                                 "Grains/Size table",
                                 "Grains/Second species/Size table",
                                 "Packing/File"})
    if (const std::string name = table.word(path); !name.empty())
      table.set(path + " = " +
                std::filesystem::absolute(table.folder(path) / name)
                    .lexically_normal()
                    .string());
}
} // namespace tamp::apps
