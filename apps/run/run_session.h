// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_run_session_h
#define apps_run_run_session_h

#include <apps/input/run_input.h>
#include <apps/output/plots.h>
#include <apps/run/progress.h>
#include <apps/run/run_folder.h>
#include <apps/run/run_log.h>
#include <coupling/checkpoint.h>
#include <fem/state_bytes.h>

#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tamp::apps
{
/// What the program returns to the shell.
enum ExitCode {
  exit_done = 0,
  exit_input = 2,
  exit_not_converged = 3,
  exit_output = 4,
  exit_check_failed = 5,
  exit_signal = 128
};

/// What a user says on the command line of a run.
struct RunOptions {
  std::filesystem::path input;  ///< empty: a command without one
  std::filesystem::path output; ///< empty: results/<name of the input>
  std::vector<std::string> settings;
  std::optional<int> threads; ///< none: all cores this rank may use
  bool force = false;
  bool resume = false; ///< go on with the run that is in the folder
  /// What else must be the same then: lines of an input, "set NAME = VALUE\n".
  std::string also_told;
  bool plots = true;
  Verbosity verbosity = Verbosity::normal;
};

/// How a run ended.
struct RunEnd {
  ExitCode code = exit_done;
  std::string message; ///< empty if all went well
};

/// Which of the ranks that mpirun started this process is.
struct RankPlace {
  unsigned rank = 0, ranks = 1;
  unsigned on_these_cores = 1; ///< ranks that may use the same cores
  bool first() const { return rank == 0; }
};

/// How an exception ends a run: InputError and std::invalid_argument with 2,
/// what cannot be written with 4, all others with 3.
RunEnd end_of(const std::exception_ptr &problem);

/// A run from its input to its folder: reads and echoes the input, keeps log
/// and record, and ends in one place. Of several ranks the first one writes
/// and speaks; the sessions of the others do the same in silence.
class RunSession
{
public:
  /// Throws InputError or OutputError; nothing is written if the input is
  /// wrong.
  RunSession(const std::string &command,
             const RunOptions &options,
             Need need,
             const RankPlace &place = {});
  /// A run that has no input but files that others wrote, such as results of
  /// earlier runs. `named`: what the user calls them. Default settings of
  /// output.
  RunSession(const std::string &command,
             const RunOptions &options,
             const std::string &named,
             const std::vector<std::filesystem::path> &files);

  const RunInput &input() const { return input_; }
  const RunFolder &folder() const { return *folder_; }
  RunLog &log() { return *log_; }
  const RankPlace &place() const { return place_; }
  unsigned threads() const { return record_.threads; }
  bool plots() const { return plots_; }
  /// Draws into plots/, unless nobody wants plots; a failure is a warning.
  void draw(const std::vector<Plot> &plots);
  /// Does the run go on from a checkpoint?
  bool resumes() const { return resumes_; }
  /// That checkpoint; null if there is none, and on other ranks than the first.
  coupling::FoundCheckpoint *found() { return found_ ? &*found_ : nullptr; }
  /// All that the run was told, see apps::whole_input(); on the first rank.
  const std::string &told() const { return told_; }
  /// Appends what the record has gathered so far; go_on() takes it up.
  void pack(std::vector<char> &bytes) const;
  void go_on(fem::StateBytes &stored);
  /// Adds a key result, "name[unit]".
  void result(const std::string &name, double value);
  /// Results from here on stand under this heading in summary.txt.
  void heading(const std::string &words);
  /// Says a warning that stays in run.json and summary.txt; the same one is
  /// said once.
  void warn(const std::string &warning);

  /// Does the work of the run, then writes run.json and summary.txt, says how
  /// it ended, and gives the program's exit code. Exceptions of the work end
  /// the run like any other end, see end_of(); but on other ranks than the
  /// first, which cannot tell, they leave it.
  int run(const std::function<RunEnd()> &work);
  /// The end after a signal that was caught.
  static RunEnd interrupted(int signal);

private:
  int finish(const RunEnd &end);

  void open_folder(const RunOptions &options, const std::string &echo);
  void start_folder(const RunOptions &options,
                    const std::filesystem::path &path,
                    const std::string &echo);

  RankPlace place_;
  RunInput input_;
  RunRecord record_;
  std::unique_ptr<RunFolder> folder_;
  std::unique_ptr<RunLog> log_;
  bool plots_, resumes_;
  std::string told_;
  std::optional<coupling::FoundCheckpoint> found_;
};

/// Number of cores this process may use.
unsigned available_cores();
/// What --threads says; if it says nothing, this rank's part of the cores that
/// it may use together with others. Throws InputError.
unsigned checked_threads(const std::optional<int> &wanted,
                         const RankPlace &place = {});
} // namespace tamp::apps

#endif
