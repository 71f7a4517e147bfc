// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/csv_line.h>
#include <apps/input/measured_table.h>

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <sstream>

namespace tamp::apps
{
namespace
{
constexpr const char *header_example =
    "names and units, for example relative_density[-], pressure[MPa]";

// The text of a file, lines ended by \n only. Throws InputError.
std::string text_of(const std::filesystem::path &file)
{
  std::ifstream in(file, std::ios::binary);
  if (!std::filesystem::is_regular_file(file) || !in)
    throw InputError(
        fmt::format("there is no measured curve '{}'", file.string()));
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF") ||
      bytes.find('\0') != std::string::npos)
    throw InputError(fmt::format(
        "{}:1: this is no CSV in UTF-8, but UTF-16 or no text at all; save the "
        "table as CSV in UTF-8",
        file.string()));
  std::string text;
  const std::string mark = "\xEF\xBB\xBF";
  for (std::size_t i = bytes.starts_with(mark) ? mark.size() : 0;
       i < bytes.size();
       ++i)
    if (bytes[i] != '\r')
      text += bytes[i];
    else if (i + 1 == bytes.size() || bytes[i + 1] != '\n')
      text += '\n';
  return text;
}

// What stands between the separators of a line, without blanks and quotes
// around it; none if a quote is not closed.
std::optional<std::vector<std::string>> split(const std::string &line,
                                              char separator)
{
  std::vector<std::string> fields;
  std::string field;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      field += line[i++];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == separator && !quoted) {
      fields.emplace_back(trimmed(field));
      field.clear();
    } else
      field += line[i];
  }
  fields.emplace_back(trimmed(field));
  if (quoted)
    return {};
  return fields;
}

// Semicolons and tabs divide nothing else, commas may.
char separator_of(const std::string &header)
{
  for (const char separator : {';', '\t'})
    if (split(header, separator).value_or(std::vector<std::string>()).size() >
        1)
      return separator;
  return ',';
}

// "Relative density" is relative_density.
std::string plain(const std::string &name)
{
  std::string words(trimmed(name));
  for (char &letter : words)
    letter = letter == ' ' || letter == '-'
                 ? '_'
                 : static_cast<char>(
                       std::tolower(static_cast<unsigned char>(letter)));
  return words;
}

// A number with a decimal point or comma.
std::optional<double> decimal(std::string field)
{
  std::ranges::replace(field, ',', '.');
  if (field.starts_with('+'))
    field.erase(0, 1);
  return number_of(field);
}
} // namespace

MeasuredTable::MeasuredTable(const std::filesystem::path &file) : file_(file)
{
  std::istringstream in(text_of(file));
  unsigned number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const std::string_view text = trimmed(line);
    if (text.empty() || text.front() == '#' || text.starts_with("sep="))
      continue;
    if (header_line_ == 0)
      take_header(line, number);
    else if (text.find_first_not_of(std::string(1, separator_) + " \t") !=
             std::string::npos)
      take_row(line, number);
  }
  if (header_line_ == 0)
    complain(std::max(number, 1u),
             fmt::format("the file is empty; expected {}", header_example));
  if (rows_.empty())
    complain(header_line_, "there is nothing below the header");
}

void MeasuredTable::complain(unsigned line, const std::string &problem) const
{
  throw InputError(fmt::format("{}:{}: {}", file_.string(), line, problem));
}

void MeasuredTable::take_header(const std::string &text, unsigned line)
{
  header_line_ = line;
  separator_ = separator_of(text);
  const auto fields = split(text, separator_);
  if (!fields)
    complain(line, "a quote is not closed");
  if (std::ranges::all_of(*fields, [](const auto &field) {
        return decimal(field).has_value();
      }))
    complain(line,
             fmt::format("'{}': expected a header with {}",
                         trimmed(text),
                         header_example));
  for (const std::string &field : *fields) {
    const std::size_t open = field.find_first_of("[(");
    const bool has_unit = open != std::string::npos &&
                          (field.ends_with(']') || field.ends_with(')'));
    names_.push_back(plain(has_unit ? field.substr(0, open) : field));
    units_.emplace_back(has_unit ? trimmed(std::string_view(field).substr(
                                       open + 1, field.size() - open - 2))
                                 : std::string_view());
  }
}

void MeasuredTable::take_row(const std::string &text, unsigned line)
{
  const auto fields = split(text, separator_);
  if (!fields)
    complain(line, "a quote is not closed");
  if (fields->size() != names_.size())
    complain(line,
             fmt::format("'{}': expected {} values, as in the header, not {}{}",
                         trimmed(text),
                         names_.size(),
                         fields->size(),
                         separator_ == ',' && fields->size() > names_.size()
                             ? "; where commas are decimal ones, semicolons "
                               "must divide the columns"
                             : ""));
  rows_.push_back({line, *fields});
  check_decimals(rows_.back());
}

void MeasuredTable::check_decimals(const Row &row)
{
  for (const std::string &field : row.fields) {
    if (!decimal(field))
      continue; // words, or a number with thousands parted: see value()
    if (field.find(',') != std::string::npos && comma_line_ == 0)
      comma_line_ = row.line;
    if (field.find('.') != std::string::npos && point_line_ == 0)
      point_line_ = row.line;
  }
  if (comma_line_ > 0 && point_line_ > 0)
    complain(row.line,
             fmt::format("decimal commas in line {} and decimal points in line "
                         "{}; expected one of them in all lines, and nothing "
                         "between thousands",
                         comma_line_,
                         point_line_));
}

std::optional<MeasuredTable::Column>
MeasuredTable::find(const std::string &name, const Dimension &dimension) const
{
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end())
    return {};
  if (std::find(found + 1, names_.end(), name) != names_.end())
    complain(header_line_, fmt::format("there are two columns '{}'", name));
  const auto number =
      static_cast<std::size_t>(std::distance(names_.begin(), found));
  const std::string &unit = units_[number];
  if (unit.empty())
    complain(header_line_,
             fmt::format("'{}': expected its unit with it, for example {}[{}]",
                         name,
                         name,
                         si_unit(dimension)));
  const auto factor = parse_unit(unit);
  if (!factor || factor->dimension != dimension)
    complain(header_line_,
             fmt::format("'{}[{}]': expected a unit of {}",
                         name,
                         unit,
                         described(dimension)));
  return Column{number, name, factor->value};
}

double MeasuredTable::value(std::size_t row, const Column &column) const
{
  const std::string &field = rows_[row].fields[column.number];
  const auto number = decimal(field);
  if (!number)
    complain(rows_[row].line,
             field.empty()
                 ? fmt::format("there is no value of {}", column.name)
                 : fmt::format("'{}': expected a finite number for {}, with a "
                               "decimal point or comma and nothing between "
                               "thousands",
                               field,
                               column.name));
  return *number * column.factor;
}
} // namespace tamp::apps
