// SPDX-License-Identifier: BSD-3-Clause
#include <apps/citations.h>
#include <apps/commands.h>
#include <apps/run/input_table.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>

namespace tamp::apps
{
void add_cite(CLI::App &app, int &code)
{
  CLI::App *cite = app.add_subcommand(
      "cite", "Print BibTeX entries of tamp and what it stands on");
  auto options = std::make_shared<RunOptions>();
  cite->add_option("FILE", options->input, "Only what runs of this input use");
  cite->callback([options, &code] {
    auto keys = all_citations();
    if (!options->input.empty()) {
      ParameterTable table;
      read_table(*options, table);
      keys = citations_of(table);
    }
    for (const std::string_view key : keys)
      fmt::print("{}", citation(key));
    code = exit_done;
  });
}
} // namespace tamp::apps
