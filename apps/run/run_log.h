// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_run_log_h
#define apps_run_run_log_h

#include <apps/run/progress.h>

#include <filesystem>
#include <memory>
#include <string>

namespace tamp::apps
{
/// What a run tells: everything goes to log.txt with the time; the terminal or
/// the pipe gets what the user asked for.
class RunLog
{
public:
  /// Throws OutputError if the file cannot be written.
  RunLog(const std::filesystem::path &file, Verbosity verbosity);
  /// Says nothing and keeps nothing.
  RunLog();
  ~RunLog();

  void say(const std::string &line);
  /// To the file, and to those who asked for much.
  void detail(const std::string &line);
  void warn(const std::string &line);
  void begin(const std::string &title);
  /// See Progress::update().
  void step(double share,
            double count,
            const std::string &unit,
            const std::string &line);
  void end();
  const Progress &progress() const { return progress_; }

private:
  void keep(const std::string &line);

  struct File;
  std::unique_ptr<File> file_; ///< none: nothing is kept
  Progress progress_;
};
} // namespace tamp::apps

#endif
