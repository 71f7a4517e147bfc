// SPDX-License-Identifier: BSD-3-Clause
#include <apps/output/growing_file.h>
#include <apps/probe/mean_curve.h>

#include <algorithm>
#include <cmath>
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
  std::vector<double> way; ///< in strain, from 0 to 1
};

StageLines stage_of(const NumberTable &curve, double stage)
{
  const std::size_t at = curve.column("stage");
  const std::size_t strain = curve.column("strain_xx[-]");
  StageLines lines;
  for (std::size_t i = 0; i < curve.rows.size(); ++i) {
    const bool start = i == 0;
    if (curve.rows[i][at] != stage || (start && stage > 1))
      continue;
    if (lines.rows.empty() && !start)
      lines.rows.push_back(curve.rows[i - 1]);
    lines.rows.push_back(curve.rows[i]);
  }
  for (std::size_t i = 0; i < lines.rows.size(); ++i) {
    double square = 0;
    for (std::size_t k = 0; i > 0 && k < 6; ++k)
      square += std::pow(
          lines.rows[i][strain + k] - lines.rows[i - 1][strain + k], 2);
    lines.way.push_back(i == 0 ? 0 : lines.way.back() + std::sqrt(square));
  }
  for (double &way : lines.way)
    way = lines.way.back() > 0 ? way / lines.way.back() : way;
  return lines;
}

Row at_share(const StageLines &lines, double share)
{
  const auto above = std::ranges::lower_bound(lines.way, share);
  if (above == lines.way.begin())
    return lines.rows.front();
  if (above == lines.way.end())
    return lines.rows.back();
  const auto i = static_cast<std::size_t>(above - lines.way.begin());
  const double part =
      (share - lines.way[i - 1]) / (lines.way[i] - lines.way[i - 1]);
  Row row = lines.rows[i - 1];
  for (std::size_t k = 0; k < row.size(); ++k)
    row[k] += part * (lines.rows[i][k] - row[k]);
  return row;
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

double Scatter::of_mean() const
{
  return count > 0 ? deviation / std::sqrt(static_cast<double>(count)) : 0;
}

Scatter scatter_of(std::span<const double> values)
{
  Scatter scatter;
  scatter.count = values.size();
  const auto count = static_cast<double>(values.size());
  for (const double value : values)
    scatter.mean += value / count;
  for (const double value : values)
    scatter.deviation += std::pow(value - scatter.mean, 2);
  scatter.deviation =
      values.size() > 1 ? std::sqrt(scatter.deviation / (count - 1)) : 0;
  return scatter;
}

NumberTable mean_curve(const std::vector<NumberTable> &curves)
{
  NumberTable mean = curves.at(0);
  mean.rows.clear();
  std::vector<std::size_t> scattering;
  for (const std::string &name : with_deviation) {
    scattering.push_back(mean.column(name));
    const auto unit = name.find('[');
    mean.names.push_back(name.substr(0, unit) + "_deviation" +
                         name.substr(unit));
  }
  for (const NumberTable &curve : curves)
    if (curve.names != curves[0].names)
      throw OutputError("the curves of the replicas have other columns");
  for (double stage = 1;; ++stage) {
    std::vector<StageLines> lines;
    std::size_t most = 0, least = curves[0].rows.size();
    for (const NumberTable &curve : curves) {
      lines.push_back(stage_of(curve, stage));
      most = std::max(most, lines.back().rows.size());
      least = std::min(least, lines.back().rows.size());
    }
    if (least == 0)
      return mean;
    // The start of a later stage is the end of the one before.
    for (std::size_t i = stage > 1 ? 1 : 0; i < most; ++i) {
      std::vector<Row> rows;
      for (const StageLines &curve : lines)
        rows.push_back(
            most == least
                ? curve.rows[i]
                : at_share(curve,
                           static_cast<double>(i) /
                               static_cast<double>(
                                   std::max<std::size_t>(1, most - 1))));
      mean.rows.push_back(mean_of(rows, scattering));
      mean.rows.back()[0] = static_cast<double>(mean.rows.size() - 1);
      mean.rows.back()[mean.column("stage")] = stage;
    }
  }
}
} // namespace tamp::apps
