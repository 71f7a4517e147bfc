// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_run_progress_h
#define apps_run_progress_h

#include <chrono>
#include <cstdio>
#include <string>

namespace tamp::apps
{
enum class Verbosity {
  quiet,
  normal, ///< with a bar on a terminal
  lines,  ///< never a bar
  verbose
};

/// "41 s", "3 min 20 s", "2 h 05 min".
std::string duration(double seconds);

/// What a user sees while waiting: on a terminal a bar with speed and time
/// left, in a pipe or a file plain lines. NO_COLOR is respected.
class Progress
{
public:
  explicit Progress(Verbosity verbosity, std::FILE *out = stdout);
  ~Progress();
  Progress(const Progress &) = delete;
  Progress &operator=(const Progress &) = delete;

  /// Starts a piece of work, and its clock.
  void begin(const std::string &title);
  /// `share` of the work is done, 0 to 1; `count` pieces of `unit` so far.
  /// `line` says it in words for those who have no bar; it may be empty.
  void update(double share,
              double count,
              const std::string &unit,
              const std::string &line);
  /// Ends the piece of work.
  void end();
  /// A line for everybody who is not `quiet`.
  void say(const std::string &line);
  /// A line for `verbose` only.
  void detail(const std::string &line);

  /// Since begin() [s].
  double elapsed() const;
  /// Time left, as far as one can tell from `share` [s].
  double left(double share) const;

private:
  void draw(double share, const std::string &words);
  void clear_bar();
  void print(const std::string &line);

  using Clock = std::chrono::steady_clock;
  Verbosity verbosity_;
  std::FILE *out_;
  bool bar_, color_, shown_ = false;
  std::string title_;
  Clock::time_point start_ = Clock::now(), last_{};
};
} // namespace tamp::apps

#endif
