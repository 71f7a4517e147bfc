// SPDX-License-Identifier: BSD-3-Clause
#include <apps/commands.h>
#include <apps/input/nearest_name.h>
#include <apps/input/units.h>
#include <apps/run/build_facts.h>

#include <algorithm>
#include <fmt/format.h>
#include <fstream>

namespace tamp::apps
{
namespace
{
namespace fs = std::filesystem;

fs::path examples_folder()
{
  const BuildFacts facts = build_facts();
  for (const fs::path folder :
       {facts.source_examples, facts.installed_examples})
    if (fs::is_directory(folder))
      return folder;
  throw OutputError(fmt::format("the examples are not installed; expected them "
                                "in '{}'",
                                facts.installed_examples));
}

std::vector<std::string> names_of_examples()
{
  std::vector<std::string> names;
  for (const auto &entry : fs::directory_iterator(examples_folder()))
    if (entry.is_directory())
      names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

// The first line of the README, without its marks.
std::string title_of(const fs::path &example)
{
  std::ifstream in(example / "README.md");
  std::string line;
  std::getline(in, line);
  return line.starts_with("# ") ? line.substr(2) : line;
}
} // namespace

int list_examples()
{
  for (const std::string &name : names_of_examples())
    fmt::print("{:<20} {}\n", name, title_of(examples_folder() / name));
  return exit_done;
}

fs::path find_example(const std::string &name)
{
  const auto names = names_of_examples();
  if (!std::ranges::count(names, name))
    throw InputError(fmt::format("there is no example '{}'; did you mean "
                                 "'{}'? 'tamp examples list' shows all",
                                 name,
                                 nearest_name(name, names)));
  return examples_folder() / name;
}

int copy_example(const std::string &name, const fs::path &folder)
{
  const fs::path example = find_example(name);
  const fs::path target = folder / name;
  if (fs::exists(target))
    throw InputError(fmt::format("'{}' exists already; nothing was copied",
                                 target.string()));
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error)
    fs::copy(example, target, fs::copy_options::recursive, error);
  if (error)
    throw OutputError(fmt::format(
        "'{}' cannot be written: {}", target.string(), error.message()));
  fmt::print("Copied to {}\n", target.string());
  return exit_done;
}
} // namespace tamp::apps
