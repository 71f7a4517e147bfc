// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/csv_line.h>
#include <apps/output/growing_file.h>
#include <apps/output/number_table.h>

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
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
  std::ifstream in(file);
  NumberTable table;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.starts_with("#")) {
      table.remarks.push_back(
          line.substr(std::min<std::size_t>(2, line.size())));
      continue;
    }
    const std::vector<std::string> fields = fields_of(line);
    if (table.names.empty()) {
      table.names = fields;
      continue;
    }
    std::vector<double> row;
    for (const std::string &field : fields)
      if (const auto value = number_of(field))
        row.push_back(*value);
    if (row.size() != table.names.size())
      throw OutputError(fmt::format("{}:{}: expected {} numbers",
                                    file.string(),
                                    number,
                                    table.names.size()));
    table.rows.push_back(std::move(row));
  }
  if (table.names.empty())
    throw OutputError(fmt::format("'{}' cannot be read", file.string()));
  return table;
}
} // namespace tamp::apps
