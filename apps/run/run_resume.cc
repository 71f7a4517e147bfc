// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/units.h>
#include <apps/run/build_facts.h>
#include <apps/run/run_folder.h>
#include <apps/run/run_resume.h>

#include <fmt/format.h>
#include <map>
#include <set>
#include <sstream>

namespace tamp::apps
{
namespace
{
const std::string file_mark = "content of ";
const std::set<std::string> without_effect{"Output/Checkpoint interval",
                                           "Output/Plot format"};

// The entries of an echo by their paths.
std::map<std::string, std::string> entries_of(const std::string &input)
{
  std::map<std::string, std::string> entries;
  std::vector<std::string> sections;
  std::istringstream lines(input);
  for (std::string line; std::getline(lines, line);) {
    line.erase(0, std::min(line.size(), line.find_first_not_of(' ')));
    if (const auto unit = line.rfind(" # ["); unit != std::string::npos)
      line.erase(unit, 2);
    if (line.starts_with("subsection "))
      sections.push_back(line.substr(11) + "/");
    else if (line == "end" && !sections.empty())
      sections.pop_back();
    else if (line.starts_with("set ")) {
      const auto equals = line.find(" = ");
      std::string path;
      for (const std::string &section : sections)
        path += section;
      path += line.substr(4, equals - 4);
      if (!without_effect.contains(path))
        entries[path] = line.substr(std::min(line.size(), equals + 3));
    }
  }
  return entries;
}
} // namespace

std::string whole_input(const std::string &echo,
                        const std::vector<std::filesystem::path> &files)
{
  std::string input = echo;
  for (const auto &file : files) {
    const std::vector<char> bytes = coupling::read_whole_file(file);
    input += fmt::format("set {}{} = {}\n",
                         file_mark,
                         file.filename().string(),
                         text_hash({bytes.begin(), bytes.end()}));
  }
  return input;
}

std::string effective_input(const std::string &input)
{
  std::string lines;
  for (const auto &[path, value] : entries_of(input))
    lines += fmt::format("set {} = {}\n", path, value);
  return lines;
}

std::string differences(const std::string &now, const std::string &then)
{
  const auto entries = entries_of(now), earlier = entries_of(then);
  std::string text;
  const auto add = [&](const std::string &difference) {
    text += (text.empty() ? "" : "; ") + difference;
  };
  for (const auto &[path, value] : entries) {
    const auto before = earlier.find(path);
    if (before == earlier.end())
      add(fmt::format("{} = {}, was not there", path, value));
    else if (before->second != value && path.starts_with(file_mark))
      add(fmt::format("the {} is another", path));
    else if (before->second != value)
      add(fmt::format("{} = {}, was {}", path, value, before->second));
  }
  for (const auto &[path, value] : earlier)
    if (!entries.contains(path))
      add(fmt::format("{} was {}", path, value));
  return text;
}

coupling::FoundCheckpoint find_to_resume(const std::filesystem::path &folder,
                                         const std::string &input)
{
  RunFolder::existing(folder);
  try {
    auto found =
        coupling::find_checkpoint(folder / "checkpoint", build_facts().version);
    if (!found)
      throw InputError(fmt::format(
          "--resume: there is no checkpoint in '{}'. Nothing was changed; "
          "without --resume, and with --force, the run starts anew",
          (folder / "checkpoint").string()));
    const std::string difference = differences(input, found->title.input);
    if (!difference.empty())
      throw InputError(fmt::format(
          "--resume: the input is not that of the run in '{}': {}. Nothing was "
          "changed; resume with the same input, or start a new run",
          folder.string(),
          difference));
    return std::move(*found);
  } catch (const coupling::FileError &error) {
    throw OutputError(
        fmt::format("--resume: {}. Nothing was changed", error.what()));
  }
}
} // namespace tamp::apps
