// SPDX-License-Identifier: BSD-3-Clause
#include <apps/commands.h>
#include <apps/input/input_purpose.h>
#include <apps/input/units.h>
#include <apps/run/input_table.h>

#include <cstdlib>
#include <fmt/format.h>
#include <unistd.h>

namespace tamp::apps
{
namespace
{
namespace fs = std::filesystem;

// The only input of an example.
fs::path input_of(const fs::path &example)
{
  fs::path input;
  for (const auto &entry : fs::directory_iterator(example))
    if (entry.path().extension() == ".prm") {
      if (!input.empty())
        throw InputError(fmt::format("the example '{}' has several inputs and "
                                     "no run.sh; its README.md says what to do",
                                     example.filename().string()));
      input = entry.path();
    }
  if (input.empty())
    throw InputError(fmt::format("the example '{}' has nothing to run",
                                 example.filename().string()));
  return input;
}

// Does not return unless it fails.
[[noreturn]] void
become_script(const fs::path &script, const fs::path &folder, bool force)
{
  if (fs::exists(folder) && !force)
    throw InputError(
        fmt::format("'{}' exists already; use --force to overwrite "
                    "what is in it, or --output",
                    folder.string()));
  if (force)
    setenv("FORCE", "1", 1);
  const std::string self = fs::read_symlink("/proc/self/exe").string();
  execlp("bash",
         "bash",
         script.c_str(),
         self.c_str(),
         folder.c_str(),
         static_cast<char *>(nullptr));
  throw OutputError(
      fmt::format("'{}' cannot be run: there is no bash", script.string()));
}

int run_input(const RunOptions &options)
{
  ParameterTable table;
  read_table(options, table);
  switch (purposes(table).front()) {
  case Need::die:
    return run_die(options);
  case Need::contact:
    return run_contact(options);
  case Need::pack:
    return run_pack(options);
  default:
    return run_probe(options);
  }
}
} // namespace

int run_example(const std::string &name, RunOptions options)
{
  const fs::path example = find_example(name);
  if (options.output.empty())
    options.output = fs::path("results") / name;
  if (const fs::path script = example / "run.sh"; fs::exists(script))
    become_script(script, options.output, options.force);
  options.input = input_of(example);
  return run_input(options);
}
} // namespace tamp::apps
