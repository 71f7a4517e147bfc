// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/parameter_table.h>
#include <apps/input/value_checks.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
std::string in_small_letters(std::string text)
{
  std::ranges::transform(text, text.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return text;
}

const std::string &entry_of(const std::string &problem,
                            const std::vector<std::string> &paths)
{
  const std::string message = in_small_letters(problem);
  const std::string *best = &paths.front();
  std::size_t longest = 0;
  for (const std::string &path : paths) {
    const std::string name =
        in_small_letters(path.substr(path.find_last_of('/') + 1));
    if (name.size() > longest && message.find(name) != std::string::npos) {
      longest = name.size();
      best = &path;
    }
  }
  return *best;
}
} // namespace

void check_values(const ParameterTable &table,
                  const std::vector<std::string> &paths,
                  const std::function<void()> &check)
{
  try {
    check();
  } catch (const InputError &) {
    throw;
  } catch (const std::invalid_argument &error) {
    table.complain(entry_of(error.what(), paths), error.what());
  }
}
} // namespace tamp::apps
