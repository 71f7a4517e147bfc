// SPDX-License-Identifier: BSD-3-Clause
#include <apps/csv_line.h>
#include <apps/size_table_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace tamp::apps
{
namespace
{
constexpr double rounding = 0.01; // of the sum of all shares, as people write

struct ShareColumn {
  const char *name;
  bool cumulative;
  dem::ShareBasis basis;
};
constexpr std::array share_columns{
    ShareColumn{"cumulative_share_by_number", true, dem::ShareBasis::number},
    ShareColumn{"cumulative_share_by_volume", true, dem::ShareBasis::volume},
    ShareColumn{"cumulative_share_by_mass", true, dem::ShareBasis::volume},
    ShareColumn{"share_by_number", false, dem::ShareBasis::number},
    ShareColumn{"share_by_volume", false, dem::ShareBasis::volume},
    ShareColumn{"share_by_mass", false, dem::ShareBasis::volume}};
constexpr const char *expected_header =
    "expected a header with diameter[um] (or another length) and one of "
    "cumulative_share_by_number[-], ..._by_volume, ..._by_mass, "
    "share_by_number[-], ..._by_volume, ..._by_mass (or in [%])";

/// Reads a table line by line.
class SizeTableReader
{
public:
  explicit SizeTableReader(const std::filesystem::path &file) : file_(file) {}

  dem::GrainSizes read()
  {
    std::ifstream in(file_);
    if (!std::filesystem::is_regular_file(file_) || !in)
      throw InputError(
          fmt::format("there is no size table '{}'", file_.string()));
    std::string text;
    while (std::getline(in, text)) {
      ++line_;
      const std::string line(trimmed(text));
      if (line.empty() || line.front() == '#')
        continue;
      if (!share_)
        take_header(line);
      else
        take_line(line);
    }
    if (!share_)
      complain(expected_header);
    return finish();
  }

private:
  [[noreturn]] void complain(const std::string &problem) const
  {
    throw InputError(
        fmt::format("{}:{}: {}", file_.string(), std::max(line_, 1u), problem));
  }

  std::optional<double> factor(const std::string &field,
                               const std::string &name,
                               const Dimension &dimension) const
  {
    try {
      return column_factor(field, name, dimension);
    } catch (const InputError &error) {
      complain(error.what());
    }
  }

  void take_header(const std::string &line)
  {
    const auto fields = fields_of(line);
    std::optional<double> length;
    for (std::size_t k = 0; k < fields.size(); ++k) {
      if (const auto found = factor(fields[k], "diameter", dimension::length)) {
        if (length)
          complain("there are two columns 'diameter'");
        length = found;
        diameter_column_ = k;
      }
      for (const ShareColumn &column : share_columns)
        if (const auto found =
                factor(fields[k], column.name, dimension::number)) {
          if (share_)
            complain(fmt::format("both '{}' and '{}' are shares; expected one",
                                 share_->name,
                                 column.name));
          share_ = &column;
          share_factor_ = *found;
          share_column_ = k;
        }
    }
    if (!length || !share_)
      complain(expected_header);
    length_factor_ = *length;
    columns_ = fields.size();
  }

  void take_line(const std::string &line)
  {
    const auto fields = fields_of(line);
    if (fields.size() != columns_)
      complain(fmt::format("'{}': expected {} values, as in the header, not {}",
                           line,
                           columns_,
                           fields.size()));
    const auto diameter = number_of(fields[diameter_column_]),
               share = number_of(fields[share_column_]);
    if (!diameter || !(*diameter > 0))
      complain(fmt::format("'{}': expected a diameter above 0",
                           fields[diameter_column_]));
    if (!share || *share < 0)
      complain(fmt::format("'{}': expected a share of at least 0",
                           fields[share_column_]));
    const dem::SizeShare next{*diameter * length_factor_,
                              *share * share_factor_};
    if (!lines_.empty()) {
      if (next.diameter < lines_.back().diameter)
        complain(fmt::format("'{}': expected diameters that rise",
                             fields[diameter_column_]));
      if (share_->cumulative && next.below < lines_.back().below)
        complain(fmt::format("'{}': expected cumulative shares that rise",
                             fields[share_column_]));
    } else if (share_->cumulative && next.below > 0)
      complain(fmt::format(
          "'{}': expected 0, the share below the smallest diameter: put a line "
          "with the diameter that no grain is smaller than before this one",
          fields[share_column_]));
    lines_.push_back(next);
  }

  dem::GrainSizes finish() const
  {
    dem::GrainSizes sizes;
    sizes.distribution = dem::SizeDistribution::table;
    sizes.basis = share_->basis;
    double sum = 0;
    for (const dem::SizeShare &line : lines_) {
      if (!share_->cumulative) {
        sizes.table.push_back({line.diameter, sum});
        sum += line.below;
      } else
        sum = line.below;
      sizes.table.push_back({line.diameter, sum});
    }
    if (!(std::abs(sum - 1) <= rounding))
      complain(fmt::format("{} is {:.6g}; expected 1 (100 %)",
                           share_->cumulative ? "the last share"
                                              : "the sum of the shares",
                           sum));
    for (dem::SizeShare &line : sizes.table)
      line.below /= sum;
    try {
      sizes.check();
    } catch (const std::invalid_argument &error) {
      complain(error.what());
    }
    describe(sizes);
    return sizes;
  }

  /// Smallest, largest and mean diameter of the grains.
  static void describe(dem::GrainSizes &sizes)
  {
    constexpr std::size_t many = 1000;
    const auto radius = draw_radii(sizes, many, 1);
    sizes.minimum_diameter = sizes.table.front().diameter;
    sizes.maximum_diameter = sizes.table.back().diameter;
    sizes.mean_diameter =
        2 * std::accumulate(radius.begin(), radius.end(), 0.0) / many;
  }

  const std::filesystem::path &file_;
  unsigned line_ = 0;
  const ShareColumn *share_ = nullptr;
  std::size_t columns_ = 0, diameter_column_ = 0, share_column_ = 0;
  double length_factor_ = 1, share_factor_ = 1;
  std::vector<dem::SizeShare> lines_; // as read: below is the column's share
};
} // namespace

dem::GrainSizes read_size_table(const std::filesystem::path &file)
{
  return SizeTableReader(file).read();
}
} // namespace tamp::apps
