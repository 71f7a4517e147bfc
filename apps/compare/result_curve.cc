// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/result_curve.h>
#include <apps/input/csv_line.h>
#include <apps/input/csv_reader.h>
#include <apps/input/units.h>

#include <cassert>
#include <fmt/format.h>
#include <regex>

namespace tamp::apps
{
ResultCurve::ResultCurve(const std::filesystem::path &file) : file_(file)
{
  CsvReader reader(file, "curve");
  for (const std::string &remark : reader.remarks())
    take_remark(remark);
  for (const std::string &name : reader.names())
    if (name.empty() || number_of(name) || !columns_.try_emplace(name).second)
      reader.complain(
          fmt::format("'{}' is not the name of a column, or names a second "
                      "one; expected a header name[unit], ...",
                      name));
  while (reader.next()) {
    const std::vector<double> values = reader.numbers();
    for (std::size_t i = 0; i < values.size(); ++i)
      columns_[reader.names()[i]].push_back(values[i]);
    ++size_;
  }
  if (size_ == 0)
    reader.complain("there is no line of values");
  find_stages();
}

void ResultCurve::take_remark(const std::string &remark)
{
  static const std::regex pattern(R"(stage (\d{1,6}): (\S+).*)");
  std::smatch parts;
  if (std::regex_match(remark, parts, pattern))
    kinds_[static_cast<unsigned>(std::stoul(parts[1]))] = parts[2];
}

void ResultCurve::find_stages()
{
  const bool packings = has("packing");
  if (!packings && !has("stage")) {
    stages_ = {{1, 0, size_ - 1}};
    return;
  }
  const auto &numbers = column(packings ? "packing" : "stage");
  for (std::size_t i = 0; i < size_; ++i) {
    const auto stage = static_cast<unsigned>(numbers[i]);
    if (stages_.empty())
      stages_.push_back({stage, i, i});
    else if (stages_.back().stage != stage)
      stages_.push_back({stage, packings ? i : i - 1, i});
    stages_.back().last = i;
  }
}

const std::vector<double> &ResultCurve::column(const std::string &name) const
{
  const auto found = columns_.find(name);
  if (found == columns_.end())
    throw InputError(
        fmt::format("{}: there is no column '{}'", file_.string(), name));
  return found->second;
}

void ResultCurve::add(const std::string &name, std::vector<double> values)
{
  assert(values.size() == size_);
  columns_[name] = std::move(values);
}

std::string ResultCurve::kind(unsigned stage) const
{
  const auto found = kinds_.find(stage);
  return found == kinds_.end() ? "" : found->second;
}
} // namespace tamp::apps
