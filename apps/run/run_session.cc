// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run/build_facts.h>
#include <apps/run/input_table.h>
#include <apps/run/run_resume.h>
#include <apps/run/run_session.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <ios>
#include <new>
#include <sched.h>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace tamp::apps
{
namespace
{
bool about_output(const std::exception &error)
{
  return dynamic_cast<const OutputError *>(&error) ||
         dynamic_cast<const std::filesystem::filesystem_error *>(&error) ||
         dynamic_cast<const std::ios_base::failure *>(&error) ||
         std::string_view(error.what()).find("cannot write") !=
             std::string_view::npos;
}

// The words of a message; of deal.II's, the line that says what is wrong.
std::string one_line(std::string text)
{
  const std::string mark = "Additional information:";
  if (const auto at = text.find(mark); at != std::string::npos)
    text.erase(0, at + mark.size());
  for (const char *end : {"Stacktrace:", "-----"})
    if (const auto at = text.find(end); at != std::string::npos && at > 0)
      text.erase(at);
  std::istringstream in(text);
  std::string line;
  for (std::string word; in >> word;)
    line += (line.empty() ? "" : " ") + word;
  return line.empty() ? "the computation failed" : line;
}

std::string status_of(ExitCode code)
{
  switch (code) {
  case exit_done:
    return "done";
  case exit_not_converged:
    return "not converged";
  case exit_check_failed:
    return "check failed";
  case exit_input:
  case exit_output:
    return "failed";
  default:
    return "interrupted";
  }
}
} // namespace

RunEnd end_of(const std::exception_ptr &problem)
{
  try {
    std::rethrow_exception(problem);
  } catch (const InputError &error) {
    return {exit_input, error.what()};
  } catch (const std::invalid_argument &error) {
    return {exit_input, error.what()};
  } catch (const std::bad_alloc &) {
    return {exit_not_converged, "the memory does not suffice"};
  } catch (const std::exception &error) {
    return {about_output(error) ? exit_output : exit_not_converged,
            one_line(error.what())};
  } catch (...) {
    return {exit_not_converged, "the computation failed"};
  }
}

unsigned available_cores()
{
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0)
    return static_cast<unsigned>(std::max(1, CPU_COUNT(&set)));
  return std::max(1u, std::thread::hardware_concurrency());
}

unsigned checked_threads(const std::optional<int> &wanted,
                         const RankPlace &place)
{
  if (!wanted)
    return std::max(1u, available_cores() / place.on_these_cores);
  if (*wanted < 1)
    throw InputError(fmt::format(
        "--threads {}: expected a whole number of at least 1", *wanted));
  return static_cast<unsigned>(*wanted);
}

RunSession::RunSession(const std::string &command,
                       const RunOptions &options,
                       Need need,
                       const RankPlace &place)
    : place_(place), plots_(options.plots && place.first()),
      resumes_(options.resume)
{
  ParameterTable table;
  read_table(options, table);
  input_ = read_input(table, need);
  record_.command = command;
  record_.input = options.input;
  record_.seed = input_.material.packing.seed;
  record_.ranks = place.ranks;
  record_.threads = checked_threads(options.threads, place);
  input_.material.threads = record_.threads;
  std::ostringstream echo;
  table.echo(echo);
  record_.input_echo = echo.str();

  if (place.first()) {
    told_ = whole_input(record_.input_echo + options.also_told, input_.files);
    name_files_in_full(table);
    echo.str("");
    table.echo(echo);
    open_folder(options, echo.str());
  } else {
    folder_ = std::make_unique<RunFolder>();
    log_ = std::make_unique<RunLog>();
  }
}

RunSession::RunSession(const std::string &command,
                       const RunOptions &options,
                       const std::string &named,
                       const std::vector<std::filesystem::path> &files)
    : plots_(options.plots), resumes_(false)
{
  ParameterTable table;
  declare_parameters(table);
  input_ = read_input(table, Need::contact);
  input_.files = files;
  record_.command = command;
  record_.input = named;
  record_.threads = checked_threads(options.threads);
  told_ = whole_input("", files);
  record_.input_echo = told_;
  open_folder(options, "");
}

void RunSession::open_folder(const RunOptions &options, const std::string &echo)
{
  const auto path = options.output.empty() ? "results" / options.input.stem()
                                           : options.output;
  if (resumes_ && record_.command == "calibrate") { // its runs are its record
    folder_ = std::make_unique<RunFolder>(RunFolder::existing(path));
  } else if (resumes_) {
    folder_ = std::make_unique<RunFolder>(RunFolder::existing(path));
    const std::string command = folder_->command(); // none: it had just begun
    if (!command.empty() && command != record_.command)
      throw InputError(
          fmt::format("--resume: the run in '{}' is one of tamp {}, not of "
                      "tamp {}. Nothing was changed",
                      path.string(),
                      command,
                      record_.command));
    found_.emplace(find_to_resume(path, told_));
  } else {
    start_folder(options, path, echo);
  }
  folder_->write("run.json", record_.json());
  // mpirun gives what it starts a terminal, whatever its own output is.
  const bool lines = place_.ranks > 1 && options.verbosity == Verbosity::normal;
  log_ = std::make_unique<RunLog>(path / "log.txt",
                                  lines ? Verbosity::lines : options.verbosity);
  log_->detail(fmt::format(
      "tamp {} {} {}, input {}, {}{} threads",
      build_facts().version,
      record_.command,
      record_.input.filename().string(),
      text_hash(record_.input_echo),
      record_.ranks > 1 ? fmt::format("on {} ranks of ", record_.ranks) : "",
      record_.threads));
  if (!found_)
    return;
  for (const std::string &reason : found_->passed_over)
    warn(reason);
  log_->say(fmt::format("going on after step {}, from {}",
                        found_->title.step,
                        found_->file.string()));
}

void RunSession::start_folder(const RunOptions &options,
                              const std::filesystem::path &path,
                              const std::string &echo)
{
  std::vector<std::filesystem::path> needed = input_.files;
  if (!options.input.empty())
    needed.push_back(options.input);
  folder_ = std::make_unique<RunFolder>(path, options.force, needed);
  if (echo.empty())
    return;
  folder_->write("input.prm",
                 fmt::format("# All parameters of this run in SI, tamp {}.\n{}",
                             build_facts().version,
                             echo));
}

void RunSession::pack(std::vector<char> &bytes) const
{
  fem::append_state(bytes, record_.wall_time());
  fem::append_state(bytes, record_.cpu_time());
  fem::append_state(bytes, record_.resumed_after);
  fem::append_state(bytes, record_.warnings.size());
  for (const std::string &warning : record_.warnings)
    fem::append_state(bytes, warning);
}

void RunSession::go_on(fem::StateBytes &stored)
{
  stored.take(record_.earlier_wall_time);
  stored.take(record_.earlier_cpu_time);
  stored.take(record_.resumed_after);
  if (found_)
    record_.resumed_after.push_back(found_->title.step);
  std::size_t count = 0;
  stored.take(count);
  std::vector<std::string> all;
  for (std::string warning; all.size() < count; all.push_back(warning))
    stored.take(warning);
  for (const std::string &warning : record_.warnings)
    if (!std::ranges::count(all, warning))
      all.push_back(warning);
  record_.warnings = all;
}

void RunSession::result(const std::string &name, double value)
{
  record_.results.emplace_back(name, value + 0.); // nobody wants to read -0
}

void RunSession::heading(const std::string &words)
{
  record_.headings.emplace_back(record_.results.size(), words);
}

void RunSession::warn(const std::string &warning)
{
  if (std::ranges::count(record_.warnings, warning))
    return;
  record_.warnings.push_back(warning);
  log_->warn(warning);
}

void RunSession::draw(const std::vector<Plot> &plots)
{
  if (!plots_)
    return;
  const std::string problem = draw_plots(
      folder_->subfolder("plots"), plots, input_.output.plot_formats);
  if (!problem.empty())
    log_->warn(problem);
}

int RunSession::run(const std::function<RunEnd()> &work)
{
  RunEnd end;
  try {
    end = work();
  } catch (...) {
    if (!place_.first())
      throw;
    end = end_of(std::current_exception());
  }
  return finish(end);
}

int RunSession::finish(const RunEnd &end)
{
  if (!place_.first())
    return end.code;
  log_->end();
  record_.status = status_of(end.code);
  record_.message = end.message;
  folder_->write("run.json", record_.json());
  folder_->write("summary.txt", record_.summary());
  if (end.code == exit_done) {
    log_->say(record_.summary());
    log_->say(fmt::format("Results are in {}", folder_->path().string()));
  } else
    log_->detail(fmt::format("{}: {}; results so far are in {}",
                             record_.status,
                             end.message,
                             folder_->path().string()));
  if (end.code == exit_input)
    fmt::print(stderr, "tamp: {}\n", end.message);
  else if (end.code != exit_done)
    fmt::print(stderr,
               "tamp: {}: {}. The results so far are in {}\n",
               record_.status,
               end.message,
               folder_->path().string());
  return end.code;
}

RunEnd RunSession::interrupted(int signal)
{
  return {static_cast<ExitCode>(exit_signal + signal),
          signal == SIGINT ? "SIGINT was received" : "SIGTERM was received"};
}
} // namespace tamp::apps
