// SPDX-License-Identifier: BSD-3-Clause
#include <apps/check/check_report.h>

#include <cmath>
#include <cstdio>
#include <fmt/format.h>

namespace tamp::apps
{
namespace
{
// To two digits; whole if there are more before the point.
std::string two_digits(double value)
{
  if (!(value > 0) || !std::isfinite(value))
    return fmt::format("{:.2g}", value);
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return fmt::format("{:.12g}", std::round(value / unit) * unit);
}
} // namespace

void CheckReport::section(const std::string &title)
{
  fmt::print("\n{}\n", title);
}

void CheckReport::line(const std::string &label, const std::string &text)
{
  fmt::print("  {:<22} {}\n", label, text);
}

void CheckReport::doubt(const std::string &text)
{
  ++doubts_;
  fmt::print("  doubtful: {}\n", text);
}

void CheckReport::failure(const std::string &text)
{
  ++failures_;
  fmt::print("  failed: {}\n", text);
}

std::string about_seconds(double seconds)
{
  constexpr double minute = 60, hour = 3600, day = 24 * hour;
  if (seconds < 1)
    return "less than 1 s";
  if (seconds < 2 * minute)
    return "about " + two_digits(seconds) + " s";
  if (seconds < 2 * hour)
    return "about " + two_digits(seconds / minute) + " min";
  if (seconds < 2 * day)
    return "about " + two_digits(seconds / hour) + " h";
  return "about " + two_digits(seconds / day) + " days";
}

std::string megabytes(double bytes)
{
  return bytes < 0.95e9 ? fmt::format("{:.3g} MB", bytes / 1e6)
                        : fmt::format("{:.3g} GB", bytes / 1e9);
}
} // namespace tamp::apps
