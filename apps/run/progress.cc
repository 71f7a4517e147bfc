// SPDX-License-Identifier: BSD-3-Clause
#include <apps/run/progress.h>

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace tamp::apps
{
namespace
{
constexpr std::size_t shortest_bar = 8, longest_bar = 30;
constexpr double seconds_between_bars = 0.1;

// Width of the terminal, or what was always safe.
std::size_t columns_of(std::FILE *out)
{
  winsize size{};
  if (ioctl(fileno(out), TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    return size.ws_col;
  return 80;
}
} // namespace

std::string duration(double seconds)
{
  const auto whole = static_cast<long>(std::clamp(seconds, 0.0, 1e8) + 0.5);
  if (whole < 60)
    return fmt::format("{} s", whole);
  if (whole < 3600)
    return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

Progress::Progress(Verbosity verbosity, std::FILE *out)
    : verbosity_(verbosity), out_(out)
{
  const char *terminal = std::getenv("TERM");
  bar_ = verbosity == Verbosity::normal && isatty(fileno(out)) == 1 &&
         terminal && std::string(terminal) != "dumb";
  const char *no_color = std::getenv("NO_COLOR");
  color_ = bar_ && !(no_color && *no_color);
}

Progress::~Progress()
{
  clear_bar();
}

void Progress::begin(const std::string &title)
{
  title_ = title;
  start_ = Clock::now();
  last_ = {};
  if (!bar_)
    say(title);
}

double Progress::elapsed() const
{
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

double Progress::left(double share) const
{
  return share > 0 ? elapsed() * (1 - share) / share : 0;
}

void Progress::update(double share,
                      double count,
                      const std::string &unit,
                      const std::string &line)
{
  if (!bar_) {
    if (!line.empty())
      say(line);
    return;
  }
  const auto now = Clock::now();
  if (share < 1 &&
      std::chrono::duration<double>(now - last_).count() < seconds_between_bars)
    return;
  last_ = now;
  draw(std::clamp(share, 0.0, 1.0),
       fmt::format(" {:3.0f} %  {:.3g} {}/s  {} left",
                   100 * std::clamp(share, 0.0, 1.0),
                   count / std::max(elapsed(), 1e-9),
                   unit,
                   share > 0 ? duration(left(share)) : "?"));
}

void Progress::draw(double share, const std::string &words)
{
  // A line that wraps could not be cleared.
  const std::size_t room = columns_of(out_) - 1;
  const std::size_t taken = words.size() + shortest_bar + 1;
  const std::string title =
      title_.substr(0, room > taken ? room - taken : std::size_t(0));
  const std::size_t width =
      std::clamp(room > words.size() + title.size() + 1
                     ? room - words.size() - title.size() - 1
                     : std::size_t(0),
                 shortest_bar,
                 longest_bar);
  const auto filled =
      static_cast<std::size_t>(share * static_cast<double>(width));
  std::string blocks;
  for (std::size_t i = 0; i < width; ++i)
    blocks += i < filled ? "\u2588" : "\u2591";
  fmt::print(out_,
             "\r\033[K{} {}{}{}{}",
             title,
             color_ ? "\033[36m" : "",
             blocks,
             color_ ? "\033[0m" : "",
             words);
  std::fflush(out_);
  shown_ = true;
}

void Progress::clear_bar()
{
  if (shown_)
    fmt::print(out_, "\r\033[K");
  shown_ = false;
}

void Progress::end()
{
  clear_bar();
}

void Progress::print(const std::string &line)
{
  clear_bar();
  fmt::print(out_, "{}\n", line);
  std::fflush(out_);
}

void Progress::say(const std::string &line)
{
  if (verbosity_ != Verbosity::quiet)
    print(line);
}

void Progress::detail(const std::string &line)
{
  if (verbosity_ == Verbosity::verbose)
    print(line);
}
} // namespace tamp::apps
