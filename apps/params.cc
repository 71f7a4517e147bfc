// SPDX-License-Identifier: BSD-3-Clause
#include <apps/commands.h>
#include <apps/input/parameter_table.h>
#include <apps/input/powder.h>

#include <fmt/format.h>
#include <iostream>

namespace tamp::apps
{
int print_parameters(const std::string &format)
{
  ParameterTable table;
  declare_parameters(table);
  table.print(std::cout,
              format == "json" ? TableFormat::json
              : format == "md" ? TableFormat::md
                               : TableFormat::prm);
  return exit_done;
}

int check_parameters(const std::filesystem::path &input)
{
  ParameterTable table;
  declare_parameters(table);
  table.read(input);
  take_powder(table);
  read_input(table, Need::everything);
  fmt::print("{}: can be read\n", input.string());
  return exit_done;
}
} // namespace tamp::apps
