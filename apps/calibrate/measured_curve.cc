// SPDX-License-Identifier: BSD-3-Clause
#include <apps/calibrate/measured_curve.h>
#include <apps/input/measured_table.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <initializer_list>
#include <optional>
#include <vector>

namespace tamp::apps
{
namespace
{
using Column = MeasuredTable::Column;

// How far noise may turn back: densities by this share of their range,
// pressures by these shares of themselves and of the peak.
constexpr double density_slack = 0.005, pressure_slack = 0.2, peak_slack = 0.02;
constexpr std::size_t fewest = 5;

/// The columns of a table, and what they mean.
class CurveColumns
{
public:
  CurveColumns(const MeasuredTable &table, const CurveReference &reference)
      : table_(table), reference_(reference)
  {
    find_density();
    axial_ = first({"axial_pressure",
                    "axial_stress",
                    "upper_pressure",
                    "stress_zz",
                    "pressure"},
                   dimension::pressure);
    if (!axial_) {
      axial_ = first({"force", "upper_force"}, dimension::force);
      if (!axial_)
        complain("there is no column pressure[MPa] or force[kN]");
      if (!(reference.area > 0))
        complain("a force needs the area that it acts on: --area \"1 cm2\"");
      axial_->factor /= reference.area;
    }
    lateral_ = first(
        {"lateral_pressure", "wall_pressure", "radial_pressure", "stress_xx"},
        dimension::pressure);
  }

  CompactionPoint point(std::size_t row) const
  {
    CompactionPoint point{density(row), table_.value(row, *axial_), 0};
    if (lateral_)
      point.lateral = table_.value(row, *lateral_);
    return point;
  }
  bool has_lateral() const { return lateral_.has_value(); }
  std::string words() const
  {
    return fmt::format("{} and {}{}",
                       density_->name,
                       axial_->name,
                       lateral_ ? ", " + lateral_->name : "");
  }

private:
  enum class Kind { relative, density, height, displacement };

  [[noreturn]] void complain(const std::string &problem) const
  {
    table_.complain(table_.header_line(), problem);
  }

  std::optional<Column> first(std::initializer_list<const char *> names,
                              const Dimension &dimension) const
  {
    for (const char *name : names)
      if (const auto column = table_.find(name, dimension))
        return column;
    return {};
  }

  bool take(Kind kind,
            std::initializer_list<const char *> names,
            const Dimension &dimension)
  {
    kind_ = kind;
    density_ = first(names, dimension);
    return density_.has_value();
  }

  void find_density()
  {
    if (take(Kind::relative,
             {"relative_density", "mean_relative_density"},
             dimension::number))
      return;
    if (take(Kind::density, {"density"}, dimension::density)) {
      if (!(reference_.solid_density > 0))
        complain("a density needs that of the solid: Grains/Density");
      return;
    }
    if (!take(Kind::height, {"height"}, dimension::length) &&
        !take(Kind::displacement,
              {"displacement", "upper_displacement"},
              dimension::length))
      complain("there is no column relative_density[-], density[g/cm3], "
               "height[mm] or displacement[mm]");
    if (!(reference_.density_at_start > 0))
      complain(density_->name + " needs the relative density of the powder at "
                                "the start: --density-at-start 0.4");
    height_ = kind_ == Kind::height ? table_.value(0, *density_)
                                    : reference_.height_at_start;
    if (!(height_ > 0))
      complain(density_->name + " needs the height of the powder at the start: "
                                "--height-at-start \"10 mm\"");
  }

  double density(std::size_t row) const
  {
    double value = table_.value(row, *density_);
    switch (kind_) {
    case Kind::relative:
      break;
    case Kind::density:
      value /= reference_.solid_density;
      break;
    case Kind::height:
      value = reference_.density_at_start * height_ / value;
      break;
    case Kind::displacement:
      value = reference_.density_at_start * height_ / (height_ - value);
    }
    if (!(value > 0 && value <= 1))
      table_.complain(table_.line(row),
                      fmt::format("{} gives a relative density of {:.4g}; "
                                  "expected one above 0 and up to 1{}",
                                  density_->name,
                                  value,
                                  value > 1 && kind_ == Kind::relative
                                      ? " (or relative_density[%])"
                                      : ""));
    return value;
  }

  const MeasuredTable &table_;
  const CurveReference &reference_;
  Kind kind_ = Kind::relative;
  std::optional<Column> density_, axial_, lateral_;
  double height_ = 0;
};

// Throws InputError if the points do not go up once and down once.
void check_turns(const MeasuredTable &table,
                 const std::vector<CompactionPoint> &points,
                 std::size_t peak)
{
  const auto [low, high] =
      std::ranges::minmax(points, {}, &CompactionPoint::relative_density);
  const double slack =
      density_slack * (high.relative_density - low.relative_density);
  const double largest =
      std::ranges::max(points, {}, &CompactionPoint::axial).axial;
  double density = points[0].relative_density, pressure = points[0].axial;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool loading = i <= peak;
    const double sign = loading ? 1 : -1;
    const CompactionPoint &point = points[i];
    if (sign * (point.relative_density - density) < -slack)
      table.complain(
          table.line(i),
          fmt::format("relative density {} from {:.5g} to {:.5g} while the "
                      "powder is {} (it is densest in line {}); expected one "
                      "loading and at most one unloading",
                      loading ? "falls" : "rises",
                      density,
                      point.relative_density,
                      loading ? "loaded" : "unloaded",
                      table.line(peak)));
    if (sign * (point.axial - pressure) <
        -pressure_slack * std::abs(pressure) - peak_slack * largest)
      table.complain(table.line(i),
                     fmt::format("pressure {} from {:.4g} to {:.4g} MPa while "
                                 "the powder is {}",
                                 loading ? "falls" : "rises",
                                 pressure / 1e6,
                                 point.axial / 1e6,
                                 loading ? "loaded" : "unloaded"));
    const auto further = [&](double a, double b) {
      return loading ? std::max(a, b) : std::min(a, b);
    };
    density = further(density, point.relative_density);
    pressure = further(pressure, point.axial);
  }
}

void check_pressures(const MeasuredTable &table,
                     std::vector<CompactionPoint> &points)
{
  const double largest =
      std::ranges::max(points, {}, &CompactionPoint::axial).axial;
  if (!(largest > 0))
    table.complain(table.line(0),
                   "no pressure is above 0; expected compression positive");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].axial < -peak_slack * largest)
      table.complain(table.line(i),
                     fmt::format("the pressure is {:.4g} MPa; expected "
                                 "compression positive",
                                 points[i].axial / 1e6));
    points[i].axial = std::max(0.0, points[i].axial); // a drift of the zero
  }
}

std::vector<CompactionPoint>
averaged(const std::vector<CompactionPoint> &points, std::size_t most)
{
  if (points.size() <= most)
    return points;
  const auto [low, high] =
      std::ranges::minmax(points, {}, &CompactionPoint::relative_density);
  const double width = (high.relative_density - low.relative_density) *
                       (1 + 1e-12) / static_cast<double>(most);
  std::vector<CompactionPoint> sums(most);
  std::vector<double> counts(most, 0.0);
  for (const CompactionPoint &point : points) {
    const auto k =
        std::min(most - 1,
                 static_cast<std::size_t>(
                     (point.relative_density - low.relative_density) / width));
    sums[k].relative_density += point.relative_density;
    sums[k].axial += point.axial;
    sums[k].lateral += point.lateral;
    ++counts[k];
  }
  std::vector<CompactionPoint> means;
  for (std::size_t k = 0; k < most; ++k)
    if (counts[k] > 0)
      means.push_back({sums[k].relative_density / counts[k],
                       sums[k].axial / counts[k],
                       sums[k].lateral / counts[k]});
  if (points.front().relative_density > points.back().relative_density)
    std::ranges::reverse(means);
  return means;
}
} // namespace

MeasuredCurve read_measured_curve(const std::filesystem::path &file,
                                  const CurveReference &reference)
{
  const MeasuredTable table(file);
  const CurveColumns columns(table, reference);
  std::vector<CompactionPoint> points;
  for (std::size_t row = 0; row < table.rows(); ++row)
    points.push_back(columns.point(row));
  check_pressures(table, points);
  const auto densest =
      std::ranges::max_element(points, {}, &CompactionPoint::relative_density);
  const auto peak =
      static_cast<std::size_t>(std::distance(points.begin(), densest));
  check_turns(table, points, peak);
  if (peak + 1 < fewest)
    table.complain(
        table.line(peak),
        fmt::format("the powder is densest here, after {} lines of loading; "
                    "expected at least {}",
                    peak + 1,
                    fewest));
  MeasuredCurve measured;
  measured.columns = columns.words();
  measured.rows = table.rows();
  measured.curve.has_lateral = columns.has_lateral();
  measured.curve.loading.assign(points.begin(), densest + 1);
  measured.curve.unloading.assign(densest + 1, points.end());
  return measured;
}

CompactionCurve thinned(const CompactionCurve &curve, std::size_t most)
{
  CompactionCurve few = curve;
  few.loading.pop_back();
  few.loading = averaged(few.loading, most - 1);
  few.loading.push_back(curve.peak());
  few.unloading = averaged(curve.unloading, most);
  return few;
}
} // namespace tamp::apps
