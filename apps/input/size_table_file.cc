// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/csv_reader.h>
#include <apps/input/size_table_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
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
  explicit SizeTableReader(const std::filesystem::path &file)
      : reader_(file, "size table")
  {
  }

  dem::GrainSizes read()
  {
    find_columns();
    while (reader_.next())
      take_line();
    return finish();
  }

private:
  void find_columns()
  {
    diameter_ = reader_.find("diameter", dimension::length);
    for (const ShareColumn &column : share_columns)
      if (const auto found = reader_.find(column.name, dimension::number)) {
        if (share_)
          reader_.complain(
              fmt::format("both '{}' and '{}' are shares; expected one",
                          share_->name,
                          column.name));
        share_ = &column;
        share_value_ = found;
      }
    if (!diameter_ || !share_)
      reader_.complain(expected_header);
  }

  void take_line()
  {
    const dem::SizeShare next{reader_.number(*diameter_),
                              reader_.number(*share_value_)};
    const auto expect = [&](bool good,
                            const std::optional<CsvReader::Column> &column,
                            const std::string &expected) {
      if (!good)
        reader_.complain(
            fmt::format("'{}': expected {}", reader_.text(*column), expected));
    };
    expect(next.diameter > 0, diameter_, "a diameter above 0");
    expect(next.below >= 0, share_value_, "a share of at least 0");
    if (!lines_.empty())
      expect(next.diameter >= lines_.back().diameter,
             diameter_,
             "diameters that rise");
    if (share_->cumulative && !lines_.empty())
      expect(next.below >= lines_.back().below,
             share_value_,
             "cumulative shares that rise");
    if (share_->cumulative && lines_.empty())
      expect(next.below == 0,
             share_value_,
             "0, the share below the smallest diameter: put a line with the "
             "diameter that no grain is smaller than before this one");
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
      reader_.complain(fmt::format("{} is {:.6g}; expected 1 (100 %)",
                                   share_->cumulative ? "the last share"
                                                      : "the sum of the shares",
                                   sum));
    for (dem::SizeShare &line : sizes.table)
      line.below /= sum;
    try {
      sizes.check();
    } catch (const std::invalid_argument &error) {
      reader_.complain(error.what());
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

  CsvReader reader_;
  const ShareColumn *share_ = nullptr;
  std::optional<CsvReader::Column> diameter_, share_value_;
  std::vector<dem::SizeShare> lines_; // as read: below is the column's share
};
} // namespace

dem::GrainSizes read_size_table(const std::filesystem::path &file)
{
  return SizeTableReader(file).read();
}
} // namespace tamp::apps
