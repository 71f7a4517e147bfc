// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/curve_writer.h>
#include <apps/run/run_log.h>

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

namespace tamp::apps
{
struct RunLog::File {
  spdlog::logger log;
};

RunLog::RunLog(const std::filesystem::path &file, Verbosity verbosity)
    : progress_(verbosity)
{
  try {
    auto sink =
        std::make_shared<spdlog::sinks::basic_file_sink_st>(file.string());
    file_ = std::make_unique<File>(File{spdlog::logger("run", sink)});
  } catch (const spdlog::spdlog_ex &error) {
    throw OutputError(error.what());
  }
  file_->log.set_pattern("%Y-%m-%d %H:%M:%S %l: %v");
  file_->log.flush_on(spdlog::level::info);
}
RunLog::RunLog() : progress_(Verbosity::quiet) {}
RunLog::~RunLog() = default;

void RunLog::keep(const std::string &line)
{
  if (file_)
    file_->log.info(line);
}

void RunLog::say(const std::string &line)
{
  keep(line);
  progress_.say(line);
}

void RunLog::detail(const std::string &line)
{
  keep(line);
  progress_.detail(line);
}

void RunLog::warn(const std::string &line)
{
  if (file_)
    file_->log.warn(line);
  progress_.say("warning: " + line);
}

void RunLog::begin(const std::string &title)
{
  keep(title);
  progress_.begin(title);
}

void RunLog::step(double share,
                  double count,
                  const std::string &unit,
                  const std::string &line)
{
  if (!line.empty())
    keep(line);
  progress_.update(share, count, unit, line);
}

void RunLog::end()
{
  progress_.end();
}
} // namespace tamp::apps
