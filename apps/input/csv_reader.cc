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
    names_ = fields_;
}

std::optional<CsvReader::Column>
CsvReader::find(const std::string &name, const Dimension &dimension) const
{
  std::optional<Column> found;
  for (std::size_t k = 0; k < names_.size(); ++k) {
    if (!names_[k].starts_with(name + "[") || !names_[k].ends_with(']'))
      continue;
    const std::size_t begin = name.size() + 1;
    const auto unit =
        parse_unit(names_[k].substr(begin, names_[k].size() - begin - 1));
    if (!unit || unit->dimension != dimension)
      complain(fmt::format(
          "'{}': expected a unit of {}", names_[k], described(dimension)));
    if (found)
      complain("there are two columns '" + name + "'");
    found = {k, unit->value};
  }
  return found;
}

CsvReader::Column CsvReader::column(const std::string &name,
                                    const Dimension &dimension) const
{
  const auto found = find(name, dimension);
  if (!found)
    complain(
        fmt::format("there is no column '{}[{}]'", name, si_unit(dimension)));
  return *found;
}

bool CsvReader::next()
{
  if (!read_line())
    return false;
  if (fields_.size() != names_.size())
    complain(fmt::format("'{}': expected {} values, as in the header, not {}",
                         text_,
                         names_.size(),
                         fields_.size()));
  return true;
}

double CsvReader::number(const Column &column) const
{
  const auto value = number_of(text(column));
  if (!value)
    complain(fmt::format("'{}': expected a finite number in column '{}'",
                         text(column),
                         names_[column.number]));
  return *value * column.factor;
}

std::vector<double> CsvReader::numbers() const
{
  std::vector<double> all;
  for (std::size_t k = 0; k < fields_.size(); ++k)
    all.push_back(number({k, 1}));
  return all;
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
    if (text_.empty())
      continue;
    if (text_.front() != '#') {
      fields_ = fields_of(text_);
      return true;
    }
    if (names_.empty())
      remarks_.emplace_back(trimmed(text_.substr(1)));
  }
  return false;
}
} // namespace tamp::apps
