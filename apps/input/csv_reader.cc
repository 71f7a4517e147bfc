// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/csv_line.h>
#include <apps/input/csv_reader.h>

#include <algorithm>
#include <fmt/format.h>

namespace tamp::apps
{
CsvReader::CsvReader(const std::filesystem::path &file, const std::string &what)
    : file_(file), in_(file)
{
  if (!std::filesystem::is_regular_file(file) || !in_)
    throw InputError(fmt::format("there is no {} '{}'", what, file.string()));
  if (read_line())
    header_ = fields_;
}

std::optional<CsvReader::Column>
CsvReader::find(const std::string &name, const Dimension &dimension) const
{
  std::optional<Column> column;
  for (std::size_t k = 0; k < header_.size(); ++k)
    try {
      if (const auto factor = column_factor(header_[k], name, dimension)) {
        if (column)
          throw InputError("there are two columns '" + name + "'");
        column = {k, *factor};
      }
    } catch (const InputError &error) {
      complain(error.what());
    }
  return column;
}

bool CsvReader::next()
{
  if (!read_line())
    return false;
  if (fields_.size() != header_.size())
    complain(fmt::format("'{}': expected {} values, as in the header, not {}",
                         text_,
                         header_.size(),
                         fields_.size()));
  return true;
}

double CsvReader::number(const Column &column) const
{
  const auto value = number_of(text(column));
  if (!value)
    complain(fmt::format("'{}': expected a number", text(column)));
  return *value * column.factor;
}

void CsvReader::complain(const std::string &problem) const
{
  throw InputError(
      fmt::format("{}:{}: {}", file_.string(), std::max(line_, 1u), problem));
}

// The next line that is neither empty nor a remark.
bool CsvReader::read_line()
{
  std::string line;
  while (std::getline(in_, line)) {
    ++line_;
    text_ = trimmed(line);
    if (text_.empty() || text_.front() == '#')
      continue;
    fields_ = fields_of(text_);
    return true;
  }
  return false;
}
} // namespace tamp::apps
