// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/nearest_name.h>

#include <algorithm>
#include <cctype>
#include <limits>

namespace tamp::apps
{
namespace
{
char small(char letter)
{
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}
} // namespace

std::size_t edit_distance(std::string_view first, std::string_view second)
{
  const std::size_t width = second.size() + 1;
  std::vector<std::size_t> table((first.size() + 1) * width);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t & {
    return table[i * width + j];
  };
  for (std::size_t i = 0; i <= first.size(); ++i)
    at(i, 0) = i;
  for (std::size_t j = 0; j < width; ++j)
    at(0, j) = j;
  for (std::size_t i = 1; i <= first.size(); ++i)
    for (std::size_t j = 1; j < width; ++j) {
      const char a = small(first[i - 1]), b = small(second[j - 1]);
      at(i, j) = std::min({at(i - 1, j) + 1,
                           at(i, j - 1) + 1,
                           at(i - 1, j - 1) + (a == b ? 0 : 1)});
      if (i > 1 && j > 1 && a == small(second[j - 2]) &&
          b == small(first[i - 2]))
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  return at(first.size(), second.size());
}

std::string nearest_name(std::string_view name,
                         const std::vector<std::string> &names)
{
  std::string best;
  std::size_t smallest = std::numeric_limits<std::size_t>::max();
  for (const std::string &candidate : names) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < smallest) {
      smallest = distance;
      best = candidate;
    }
  }
  return best;
}
} // namespace tamp::apps
