// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/csv_reader.h>
#include <apps/input/density_grid.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/base/table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tamp::apps
{
namespace
{
using Place = std::array<double, 3>;
using Axes = std::array<std::vector<double>, 3>;
using Grid = dealii::Functions::InterpolatedTensorProductGridData<3>;

constexpr const char *expected_header =
    "expected a header with relative_density[-] and either x[mm], y[mm] and "
    "z[mm] or r[mm] and z[mm] (or other units of length)";

std::string name_of(const Place &place, bool radial)
{
  return radial ? fmt::format("r = {:.6g} m, z = {:.6g} m", place[0], place[2])
                : fmt::format("x = {:.6g} m, y = {:.6g} m, z = {:.6g} m",
                              place[0],
                              place[1],
                              place[2]);
}

/// Densities between the places that were read.
struct DensityGrid {
  std::filesystem::path file;
  bool radial;
  Axes axes;
  std::shared_ptr<const Grid> grid;

  double operator()(const dealii::Tensor<1, 3> &at) const
  {
    const Place place = radial ? Place{std::hypot(at[0], at[1]), 0, at[2]}
                               : Place{at[0], at[1], at[2]};
    for (unsigned axis = 0; axis < 3; ++axis)
      if (place[axis] < axes[axis].front() || place[axis] > axes[axis].back())
        throw InputError(fmt::format("{}: the point at {} is outside the grid",
                                     file.string(),
                                     name_of(place, radial)));
    return grid->value({place[0], place[1], place[2]});
  }
};

/// Reads a grid line by line. A grid of r and z is one of x, y and z with r for
/// x and no y.
class DensityGridReader
{
public:
  explicit DensityGridReader(const std::filesystem::path &file)
      : file_(file), reader_(file, "table of densities")
  {
  }

  DensityField read()
  {
    find_columns();
    while (reader_.next())
      take_line();
    return field(find_axes());
  }

private:
  using Column = CsvReader::Column;

  void find_columns()
  {
    const auto r = reader_.find("r", dimension::length);
    axes_ = {reader_.find("x", dimension::length),
             reader_.find("y", dimension::length),
             reader_.find("z", dimension::length)};
    density_ = reader_.find("relative_density", dimension::number);
    radial_ = r.has_value();
    const bool one_kind =
        radial_ ? !axes_[0] && !axes_[1] : axes_[0] && axes_[1];
    if (!one_kind || !axes_[2] || !density_)
      reader_.complain(expected_header);
    if (radial_)
      axes_[0] = r;
  }

  void take_line()
  {
    Place place{};
    for (unsigned axis = 0; axis < 3; ++axis)
      if (axes_[axis])
        place[axis] = reader_.number(*axes_[axis]);
    const double density = reader_.number(*density_);
    if (!(density > 0 && density < 1))
      reader_.complain(
          fmt::format("'{}': expected a relative density between 0 and 1",
                      reader_.text(*density_)));
    if (!densities_.emplace(place, density).second)
      reader_.complain("the place of '" + reader_.line() +
                       "' has a density already");
  }

  Axes find_axes() const
  {
    Axes axes;
    for (unsigned axis = 0; axis < 3; ++axis) {
      std::vector<double> &values = axes[axis];
      for (const auto &[place, density] : densities_)
        values.push_back(place[axis]);
      std::ranges::sort(values);
      const auto repeated = std::ranges::unique(values);
      values.erase(repeated.begin(), repeated.end());
      if (radial_ && axis == 1)
        continue;
      if (values.size() < 2)
        reader_.complain(
            fmt::format("expected at least two different values of {}",
                        (radial_ ? "ryz" : "xyz")[axis]));
    }
    return axes;
  }

  DensityField field(const Axes &axes) const
  {
    // The library wants two places along each axis.
    Axes places = axes;
    if (radial_)
      places[1] = {0, 1};
    dealii::Table<3, double> table(
        places[0].size(), places[1].size(), places[2].size());
    for (std::size_t i = 0; i < places[0].size(); ++i)
      for (std::size_t j = 0; j < places[1].size(); ++j)
        for (std::size_t k = 0; k < places[2].size(); ++k)
          table(i, j, k) = density_at(
              {places[0][i], radial_ ? 0 : places[1][j], places[2][k]});
    return DensityGrid{
        file_, radial_, axes, std::make_shared<const Grid>(places, table)};
  }

  double density_at(const Place &place) const
  {
    const auto found = densities_.find(place);
    if (found == densities_.end())
      reader_.complain("there is no density at " + name_of(place, radial_) +
                       "; expected one at every place of a rectilinear grid");
    return found->second;
  }

  std::filesystem::path file_;
  CsvReader reader_;
  std::array<std::optional<Column>, 3> axes_;
  std::optional<Column> density_;
  bool radial_ = false;
  std::map<Place, double> densities_;
};
} // namespace

DensityField read_density_grid(const std::filesystem::path &file)
{
  return DensityGridReader(file).read();
}
} // namespace tamp::apps
