// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/csv_line.h>
#include <apps/input/units.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tamp::apps
{
std::vector<std::string> fields_of(const std::string &line)
{
  std::vector<std::string> fields;
  for (std::size_t start = 0; start <= line.size();) {
    const std::size_t end = std::min(line.find(',', start), line.size());
    fields.emplace_back(trimmed(line.substr(start, end - start)));
    start = end + 1;
  }
  return fields;
}

std::optional<double> number_of(const std::string &field)
{
  double value = 0;
  const char *end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value))
    return {};
  return value;
}
} // namespace tamp::apps
