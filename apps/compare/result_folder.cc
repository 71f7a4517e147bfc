// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/result_folder.h>
#include <apps/input/units.h>
#include <apps/run/run_folder.h>

#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

namespace tamp::apps
{
namespace
{
namespace fs = std::filesystem;

std::vector<WrittenFields> fields_in(const fs::path &folder)
{
  std::ifstream in(folder / "fields.pvd");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  static const std::regex pattern(
      R"rx(timestep="(\d{1,9})"[^>]*file="([^"]+)")rx");
  std::vector<WrittenFields> fields;
  for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end;
       ++i)
    fields.push_back(
        {static_cast<unsigned>(std::stoul((*i)[1])), folder / (*i)[2].str()});
  return fields;
}
} // namespace

std::optional<double> ResultFolder::result(const std::string &wanted) const
{
  for (const auto &[result, value] : results)
    if (result == wanted)
      return value;
  return {};
}

ResultFolder read_result_folder(const fs::path &path, const std::string &name)
{
  if (!fs::is_directory(path))
    throw InputError(fmt::format("there is no folder '{}'", path.string()));
  const std::string command = RunFolder::existing(path).command();
  static const std::set<std::string> known{"contact", "die", "pack", "probe"};
  if (!known.contains(command))
    throw InputError(fmt::format("'{}' is the folder of 'tamp {}'; expected "
                                 "one of tamp contact, die, pack or probe",
                                 path.string(),
                                 command));
  std::ifstream in(path / "run.json");
  const auto tree = nlohmann::ordered_json::parse(in);
  if (!std::ifstream(path / "curve.csv"))
    throw InputError(
        fmt::format("'{}' has no curve.csv: nothing of this run of tamp {} can "
                    "be compared",
                    path.string(),
                    command));
  ResultFolder folder;
  folder.path = path;
  folder.name = name;
  folder.curve = ResultCurve(path / "curve.csv");
  try {
    folder.command = command;
    folder.status = tree.at("status");
    folder.message = tree.value("message", "");
    folder.wall_time = tree.at("wall_time[s]");
    folder.cpu_time = tree.at("cpu_time[s]");
    folder.ranks = tree.value("ranks", 1.);
    folder.threads = tree.value("threads", 1.);
    for (const auto &[result, value] : tree.at("results").items())
      if (value.is_number())
        folder.results.emplace_back(result, value);
  } catch (const nlohmann::json::exception &error) {
    throw InputError(fmt::format("'{}' is not what a run of tamp writes: {}",
                                 (path / "run.json").string(),
                                 error.what()));
  }
  folder.fields = fields_in(path);
  return folder;
}
} // namespace tamp::apps
