// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/units.h>
#include <apps/run/build_facts.h>
#include <apps/run/progress.h>
#include <apps/run/run_folder.h>

#include <algorithm>
#include <ctime>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <sys/resource.h>

namespace tamp::apps
{
namespace
{
namespace fs = std::filesystem;

// All that a run that was killed as it began may leave.
constexpr const char *mark_begun = "run.json.part";

// What runs write; nothing else in a folder is ever removed, but for packings,
// see is_packing(). The mark of a run goes last: what could not be removed can
// be, next time.
constexpr const char *own_names[] = {
    "input.prm",      "log.txt",        "curve.csv",       "fields.pvd",
    "fields",         "grains.pvd",     "grains",          "plots",
    "summary.txt",    "checkpoint",     "trials.tamp",     "yield.csv",
    "moduli.csv",     "replicas.csv",   "inspect",         "compare.csv",
    "difference.vtu", "best.prm",       "calibration.csv", "measured.csv",
    "packings",       "residuals.csv",  "equations.csv",   "fit.csv",
    "law.prm",        "law_abaqus.inp", mark_begun,        "run.json"};

// packing.h5, packing_0001.txt, grains_0001.vtp, size_00200_seed_1 ...
bool is_packing(const std::string &name)
{
  static const std::regex pattern(
      R"((packing(_\d{4,})?\.(h5|txt)|grains(_\d{4,})?\.vtp|size_\d+_seed_\d+))");
  return std::regex_match(name, pattern);
}

// Names of what an earlier run may have left in a folder.
std::vector<std::string> results_in(const fs::path &folder)
{
  std::vector<std::string> names;
  std::error_code error;
  for (const auto &entry : fs::directory_iterator(folder, error))
    if (const std::string name = entry.path().filename(); is_packing(name))
      names.push_back(name);
  names.insert(names.end(), std::begin(own_names), std::end(own_names));
  return names;
}

std::string seconds(double value)
{
  return value < 10 ? fmt::format("{:.2g} s", value) : duration(value);
}

bool of_a_run(const fs::path &folder)
{
  std::ifstream in(folder / "run.json");
  const auto tree = nlohmann::json::parse(in, nullptr, false);
  return tree.is_object() && tree.contains("program") &&
         tree["program"] == "tamp";
}

bool holds_nothing(const fs::path &folder)
{
  std::error_code error;
  return std::ranges::all_of(fs::directory_iterator(folder, error),
                             [](const fs::directory_entry &entry) {
                               return entry.path().filename() == mark_begun;
                             });
}

// Whether a file is, or lies in, something that will be removed.
bool inside(const fs::path &file, const fs::path &removed)
{
  std::error_code error;
  const fs::path inner = fs::weakly_canonical(file, error);
  const fs::path outer =
      fs::weakly_canonical(removed.parent_path(), error) / removed.filename();
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end())
             .first == outer.end();
}

void check_removal(const fs::path &folder, const std::vector<fs::path> &needed)
{
  if (!holds_nothing(folder) && !of_a_run(folder))
    throw InputError(fmt::format(
        "--force: '{}' is not the folder of a run: it has no run.json of tamp. "
        "Nothing was changed; choose another folder with --output",
        folder.string()));
  for (const fs::path &file : needed)
    for (const std::string &name : results_in(folder))
      if (inside(file, folder / name))
        throw InputError(fmt::format(
            "--force would remove '{}', which this run reads. Nothing was "
            "changed; move the file, or choose another folder with --output",
            file.string()));
}

void remove_results(const fs::path &folder)
{
  for (const std::string &name : results_in(folder)) {
    std::error_code error;
    fs::remove_all(folder / name, error);
    if (error)
      throw OutputError(fmt::format("'{}' cannot be removed: {}",
                                    (folder / name).string(),
                                    error.message()));
  }
}
} // namespace

std::string with_unit(const std::string &name, double value)
{
  const auto ends = [&](const char *unit) { return name.ends_with(unit); };
  if (ends("[Pa]"))
    return fmt::format("{:.4g} MPa", value / 1e6);
  if (ends("[N]"))
    return fmt::format("{:.4g} N", value);
  if (ends("[m]"))
    return fmt::format("{:.4g} mm", value / 1e-3);
  if (ends("[s]") && value >= 0.1)
    return seconds(value);
  const std::string unit = name.substr(name.rfind('[') + 1);
  return ends("[-]")
             ? fmt::format("{:.4g}", value)
             : fmt::format("{:.4g} {}", value, unit.substr(0, unit.find(']')));
}

RunFolder::RunFolder(const fs::path &folder,
                     bool force,
                     const std::vector<fs::path> &needed)
    : folder_(folder)
{
  std::error_code error;
  const bool exists = fs::exists(folder, error);
  if (exists && !fs::is_directory(folder, error))
    throw OutputError(fmt::format(
        "'{}' is a file; expected a folder for results", folder.string()));
  if (exists && !force)
    throw InputError(
        fmt::format("the folder '{}' exists already; nothing was changed. Use "
                    "--force to overwrite the results in it, or --output to "
                    "write elsewhere",
                    folder.string()));
  if (exists) {
    check_removal(folder, needed);
    remove_results(folder);
  } else
    fs::create_directories(folder, error);
  if (error)
    throw OutputError(fmt::format("the folder '{}' cannot be written: {}",
                                  folder.string(),
                                  error.message()));
  // Its mark first: a run that is killed from here on is known as one.
  write("run.json", "{\"program\": \"tamp\"}\n");
  write("log.txt", "");
}

RunFolder RunFolder::existing(const fs::path &folder)
{
  if (!of_a_run(folder))
    throw InputError(fmt::format("'{}' is not the folder of a run: it has no "
                                 "run.json of tamp",
                                 folder.string()));
  RunFolder result;
  result.folder_ = folder;
  return result;
}

std::string RunFolder::command() const
{
  std::ifstream in(folder_ / "run.json");
  const auto tree = nlohmann::json::parse(in, nullptr, false);
  return tree.is_object() ? tree.value("command", "") : "";
}

fs::path RunFolder::subfolder(const std::string &name) const
{
  if (folder_.empty())
    return {};
  std::error_code error;
  fs::create_directories(folder_ / name, error);
  if (error)
    throw OutputError(fmt::format("the folder '{}' cannot be written: {}",
                                  (folder_ / name).string(),
                                  error.message()));
  return folder_ / name;
}

void RunFolder::write(const std::string &name, const std::string &text) const
{
  if (folder_.empty())
    return;
  const fs::path temporary = folder_ / (name + ".part");
  {
    std::ofstream out(temporary, std::ios::binary);
    out << text << std::flush;
    if (!out)
      throw OutputError(
          fmt::format("'{}' cannot be written", (folder_ / name).string()));
  }
  std::error_code error;
  fs::rename(temporary, folder_ / name, error);
  if (error)
    throw OutputError(fmt::format("'{}' cannot be written: {}",
                                  (folder_ / name).string(),
                                  error.message()));
}

std::string text_hash(const std::string &text)
{
  std::uint64_t hash = 14695981039346656037u;
  for (const char letter : text)
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211u;
  return fmt::format("{:016x}", hash);
}

double RunRecord::wall_time() const
{
  return earlier_wall_time +
         std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
             .count();
}

double RunRecord::cpu_time() const
{
  return earlier_cpu_time + static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double RunRecord::peak_memory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * double(usage.ru_maxrss);
}

std::string RunRecord::json() const
{
  const BuildFacts facts = build_facts();
  nlohmann::ordered_json tree;
  tree["program"] = "tamp";
  tree["version"] = facts.version;
  tree["build_type"] = facts.build_type;
  for (const auto &[name, version] : facts.libraries)
    tree["libraries"][name] = version;
  tree["command"] = command;
  tree["input"] = input.filename().string();
  for (const auto &folder : folders)
    tree["folders"].push_back(folder.string());
  tree["input_hash"] = text_hash(input_echo);
  tree["seeds"] = {seed};
  tree["ranks"] = ranks;
  tree["threads"] = threads;
  tree["wall_time[s]"] = wall_time();
  tree["cpu_time[s]"] = cpu_time();
  tree["peak_memory[B]"] = peak_memory();
  if (!resumed_after.empty())
    tree["resumed_after_steps"] = resumed_after;
  tree["status"] = status;
  if (!message.empty())
    tree["message"] = message;
  if (!warnings.empty())
    tree["warnings"] = warnings;
  tree["results"] = nlohmann::ordered_json::object();
  for (const auto &[name, value] : results)
    tree["results"][name] = value;
  return tree.dump(2) + "\n";
}

std::string RunRecord::summary() const
{
  std::string text =
      fmt::format("tamp {} {}\n\n", command, input.filename().string());
  const auto row = [&](const std::string &name, const std::string &value) {
    text += fmt::format("  {:<42} {}\n", name, value);
  };
  row("status", status);
  if (!message.empty())
    row("because", message);
  for (const std::string &warning : warnings)
    row("warning", warning);
  const double wall = wall_time();
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (const auto &[first, words] : headings)
      if (first == i)
        text += fmt::format("\n{}\n", words);
    const auto &[name, value] = results[i];
    std::string words = name.substr(0, name.rfind('['));
    std::ranges::replace(words, '_', ' ');
    std::string said = with_unit(name, value);
    if (name.starts_with("time_") && name.ends_with("[s]") && wall > 0)
      said += fmt::format(" ({:.0f} %)", 100 * value / wall);
    row(words, said);
  }
  if (!headings.empty())
    text += "\nRun\n";
  row("wall time", seconds(wall));
  row(ranks > 1 ? "CPU time of the first rank" : "CPU time",
      seconds(cpu_time()));
  row(ranks > 1 ? "peak memory of the first rank" : "peak memory",
      fmt::format("{:.0f} MB", peak_memory() / 1e6));
  row("ranks", fmt::format("{}", ranks));
  row(ranks > 1 ? "threads of each rank" : "threads",
      fmt::format("{}", threads));
  row("version", build_facts().version);
  return text;
}
} // namespace tamp::apps
