// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/growing_file.h>
#include <apps/output/scatter.h>
#include <apps/probe/mean_curve.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace tamp::apps
{
namespace
{
using Row = std::vector<double>;

const std::vector<std::string> with_deviation{"stress_xx[Pa]",
                                              "stress_yy[Pa]",
                                              "stress_zz[Pa]",
                                              "stress_yz[Pa]",
                                              "stress_xz[Pa]",
                                              "stress_xy[Pa]",
                                              "pressure[Pa]",
                                              "deviatoric_stress[Pa]",
                                              "relative_density[-]"};

/// The lines of a stage, that of its start first.
struct StageLines {
  std::vector<Row> rows;
  std::vector<double> way; ///< to each, in strain or as shares of the stage's
};

StageLines lines_of(const NumberTable &curve, double stage)
{
  const std::size_t at = curve.column("stage");
  const std::size_t strain = curve.column("strain_xx[-]");
  StageLines lines;
  for (const Row &row : curve.rows)
    if (row[at] < stage)
      lines.rows = {row};
    else if (!(row[at] > stage))
      lines.rows.push_back(row);
  double way = 0;
  for (std::size_t i = 0; i < lines.rows.size(); ++i) {
    double square = 0;
    for (std::size_t k = strain; i > 0 && k < strain + 6; ++k)
      square += std::pow(lines.rows[i][k] - lines.rows[i - 1][k], 2);
    lines.way.push_back(way += std::sqrt(square));
  }
  return lines;
}

/// Makes ways shares of the whole one; where nothing is strained, lines count.
void take_shares(StageLines &lines)
{
  const double whole = lines.way.back();
  for (std::size_t i = 1; i < lines.way.size(); ++i)
    lines.way[i] = whole > 0 ? lines.way[i] / whole
                             : static_cast<double>(i) /
                                   static_cast<double>(lines.way.size() - 1);
}

Row line_at(const StageLines &lines, double way)
{
  const auto above = std::ranges::lower_bound(lines.way, way);
  if (above == lines.way.end())
    return lines.rows.back();
  const auto i = static_cast<std::size_t>(above - lines.way.begin());
  if (i == 0 || !(way < *above))
    return lines.rows[i];
  const double part = (way - lines.way[i - 1]) / (*above - lines.way[i - 1]);
  Row row = lines.rows[i - 1];
  for (std::size_t k = 0; k < row.size(); ++k)
    row[k] += part * (lines.rows[i][k] - row[k]);
  return row;
}

/// One stage of all curves.
class Stage
{
public:
  /// @param broken  whether one of them broke off in it
  Stage(const std::vector<ProbeCurve> &curves, double number, bool broken)
  {
    double end = 1;
    for (const ProbeCurve &curve : curves) {
      lines_.push_back(lines_of(curve.table, number));
      if (!broken)
        take_shares(lines_.back());
      const double whole = lines_.back().way.back();
      end = lines_.size() == 1 ? whole : std::min(end, whole);
    }
    const auto count = [](const StageLines &lines) { return lines.way.size(); };
    ways_ = std::ranges::max_element(lines_, {}, count)->way;
    if (broken) {
      ways_.erase(std::ranges::lower_bound(ways_, end), ways_.end());
      ways_.push_back(end);
    }
    same_ = std::ranges::all_of(lines_, [this](const StageLines &lines) {
      return std::ranges::equal(lines.way, ways_, [](double a, double b) {
        return std::abs(a - b) <= rounding;
      });
    });
  }

  /// The lines to compare, that of the start first.
  std::size_t size() const { return ways_.size(); }
  std::vector<Row> rows(std::size_t i) const
  {
    std::vector<Row> rows;
    for (const StageLines &lines : lines_)
      rows.push_back(same_ ? lines.rows[i] : line_at(lines, ways_[i]));
    return rows;
  }

private:
  static constexpr double rounding = 1e-9; ///< of ways and shares [-]
  std::vector<StageLines> lines_;
  std::vector<double> ways_;
  bool same_ = true; ///< curves have their lines at these ways
};

double last_stage(const ProbeCurve &curve)
{
  return curve.table.rows.back()[curve.table.column("stage")];
}

/// One line of each curve.
Row mean_of(const std::vector<Row> &rows,
            const std::vector<std::size_t> &scattering)
{
  Row mean;
  std::vector<double> values(rows.size());
  const auto take = [&](std::size_t k) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      values[i] = rows[i][k];
    return scatter_of(values);
  };
  for (std::size_t k = 0; k < rows[0].size(); ++k)
    mean.push_back(take(k).mean);
  for (const std::size_t k : scattering)
    mean.push_back(take(k).deviation);
  return mean;
}
} // namespace

NumberTable mean_curve(const std::vector<ProbeCurve> &curves)
{
  NumberTable mean = curves.at(0).table;
  mean.rows.clear();
  const std::size_t stage_column = mean.column("stage");
  std::vector<std::size_t> scattering;
  for (const std::string &name : with_deviation) {
    scattering.push_back(mean.column(name));
    const auto unit = name.find('[');
    mean.names.push_back(name.substr(0, unit) + "_deviation" +
                         name.substr(unit));
  }
  double last = 0;
  std::optional<double> broken; // the first stage in which a curve broke off
  for (const ProbeCurve &curve : curves) {
    if (curve.table.names != curves[0].table.names)
      throw OutputError("the curves of the replicas have other columns");
    last = std::max(last, last_stage(curve));
    if (!curve.ended)
      broken = std::min(broken.value_or(last_stage(curve)), last_stage(curve));
  }
  for (double number = 1; number <= broken.value_or(last); ++number) {
    const Stage stage(curves, number, broken && !(number < *broken));
    // The start of a later stage is the end of the one before.
    for (std::size_t i = number > 1 ? 1 : 0; i < stage.size(); ++i) {
      mean.rows.push_back(mean_of(stage.rows(i), scattering));
      mean.rows.back()[0] = static_cast<double>(mean.rows.size() - 1);
      mean.rows.back()[stage_column] = number;
    }
  }
  return mean;
}
} // namespace tamp::apps
