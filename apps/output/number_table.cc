// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/csv_reader.h>
#include <apps/output/growing_file.h>
#include <apps/output/number_table.h>

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace tamp::apps
{
std::size_t NumberTable::column(const std::string &name) const
{
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw OutputError(fmt::format("there is no column '{}'", name));
  return static_cast<std::size_t>(std::distance(names.begin(), found));
}

NumberTable read_number_table(const std::filesystem::path &file)
{
  try {
    CsvReader reader(file, "table");
    if (reader.names().empty())
      reader.complain("there is no header");
    NumberTable table{reader.remarks(), reader.names(), {}};
    while (reader.next())
      table.rows.push_back(reader.numbers());
    return table;
  } catch (const InputError &error) {
    throw OutputError(error.what()); // no user wrote it
  }
}
} // namespace tamp::apps
