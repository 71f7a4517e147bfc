// SPDX-License-Identifier: BSD-3-Clause
#include <apps/compare/result_curve.h>
#include <apps/input/csv_line.h>
#include <apps/input/units.h>

#include <cassert>
#include <fmt/format.h>
#include <fstream>
#include <regex>

namespace tamp::apps
{
ResultCurve::ResultCurve(const std::filesystem::path &file) : file_(file)
{
  std::ifstream in(file);
  if (!in)
    throw InputError(
        fmt::format("'{}' cannot be read; expected the curve of a run of tamp",
                    file.string()));
  read(in);
  find_stages();
}

void ResultCurve::read(std::ifstream &in)
{
  std::vector<std::string> header;
  unsigned number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const auto complain = [&](const std::string &problem) {
      throw InputError(
          fmt::format("{}:{}: {}", file_.string(), number, problem));
    };
    if (header.empty() && line.starts_with('#')) {
      take_remark(line);
      continue;
    }
    const std::vector<std::string> fields = fields_of(line);
    if (header.empty()) {
      header = fields;
      for (const std::string &name : header)
        if (name.empty() || number_of(name) ||
            !columns_.try_emplace(name).second)
          complain(fmt::format("'{}' is not the name of a column, or names a "
                               "second one; expected a header name[unit], ...",
                               name));
      continue;
    }
    if (fields.size() != header.size())
      complain(fmt::format(
          "expected {} numbers, found {}", header.size(), fields.size()));
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto value = number_of(fields[i]);
      if (!value)
        complain(fmt::format(
            "column '{}': '{}' is not a finite number", header[i], fields[i]));
      columns_[header[i]].push_back(*value);
    }
    ++size_;
  }
  if (size_ == 0)
    throw InputError(fmt::format(
        "{}:{}: there is no line of values", file_.string(), number));
}

void ResultCurve::take_remark(const std::string &line)
{
  static const std::regex pattern(R"(# stage (\d{1,6}): (\S+).*)");
  std::smatch parts;
  if (std::regex_match(line, parts, pattern))
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
