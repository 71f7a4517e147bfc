// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_run_folder_h
#define apps_run_run_folder_h

#include <apps/output/curve_writer.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
/// The folder that a run writes to.
class RunFolder
{
public:
  /// No folder at all: whatever is written to it goes nowhere.
  RunFolder() = default;
  /// Makes the folder. Throws InputError, and changes nothing, if it exists
  /// and `force` is off. With `force`, results of an earlier run in it are
  /// removed, other files stay; throws InputError, and changes nothing, if it
  /// is neither empty nor the folder of a run, or if one of the files `needed`
  /// would be removed. Throws OutputError if it cannot be made or written.
  RunFolder(const std::filesystem::path &folder,
            bool force,
            const std::vector<std::filesystem::path> &needed = {});

  /// The folder of an earlier run, as it is. Throws InputError if it is none.
  static RunFolder existing(const std::filesystem::path &folder);

  const std::filesystem::path &path() const { return folder_; }
  /// The command that run.json names; empty if there is none.
  std::string command() const;
  /// Makes a folder in it. Throws OutputError.
  std::filesystem::path subfolder(const std::string &name) const;
  /// Replaces a file by `text`, as a whole. Throws OutputError.
  void write(const std::string &name, const std::string &text) const;

private:
  std::filesystem::path folder_;
};

/// What stays of a run in run.json and summary.txt.
struct RunRecord {
  std::string command;
  std::filesystem::path input;
  std::vector<std::filesystem::path> folders; ///< of runs that it reads
  std::string input_echo;                     ///< in SI; its hash is kept
  std::uint64_t seed = 0;
  unsigned ranks = 1;
  unsigned threads = 1; ///< of each rank
  std::chrono::steady_clock::time_point start =
      std::chrono::steady_clock::now();
  /// What the parts of the run before this one took, if it goes on [s].
  double earlier_wall_time = 0, earlier_cpu_time = 0;
  std::vector<unsigned> resumed_after; ///< steps
  std::string status = "running";      ///< running, done, not converged, ...
  std::string message;                 ///< why it ended, if not done
  std::vector<std::string> warnings;   ///< what to mind with the results
  /// Key results with their units, in the order of the summary.
  std::vector<std::pair<std::string, double>> results;
  /// What parts them in the summary: the number of the first result below a
  /// heading, and its words.
  std::vector<std::pair<std::size_t, std::string>> headings;

  double wall_time() const; ///< all parts of the run, until now [s]
  double cpu_time() const;  ///< likewise, of this rank [s]
  /// The most that this process has held at a time, libraries included [B].
  static double peak_memory();

  /// For run.json.
  std::string json() const;
  /// For summary.txt: results in words that a user reads.
  std::string summary() const;
};

/// The value of "name[unit]" with a unit that suits it: "52.6 MPa", "2.81 mm".
std::string with_unit(const std::string &name, double value);

/// FNV-1a, 64 bits, as sixteen hexadecimal digits.
std::string text_hash(const std::string &text);
} // namespace tamp::apps

#endif
