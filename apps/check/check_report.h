// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_check_check_report_h
#define apps_check_check_report_h

#include <string>

namespace tamp::apps
{
/// What `tamp check` says: sections of lines on stdout. Counts what is doubtful
/// and what cannot do.
class CheckReport
{
public:
  void section(const std::string &title);
  void line(const std::string &label, const std::string &text);
  /// Something that a user should know although the input can run.
  void doubt(const std::string &text);
  /// Something for which the input should not be run.
  void failure(const std::string &text);

  unsigned doubts() const { return doubts_; }
  unsigned failures() const { return failures_; }

private:
  unsigned doubts_ = 0, failures_ = 0;
};

/// "about 40 s", "about 12 min", "about 3 h", to two digits.
std::string about_seconds(double seconds);
/// "1.3 MB", to two digits at least.
std::string megabytes(double bytes);
} // namespace tamp::apps

#endif
