// SPDX-License-Identifier: BSD-3-Clause
#include <apps/csv_line.h>
#include <apps/density_grid.h>

#include <deal.II/base/function_lib.h>
#include <deal.II/base/table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <memory>
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

/// Reads a grid line by line. A grid of r and z is one of x, y and z with r for
/// x and no y.
class DensityGridReader
{
public:
  explicit DensityGridReader(const std::filesystem::path &file) : file_(file) {}

  DensityField read()
  {
    std::ifstream in(file_);
    if (!std::filesystem::is_regular_file(file_) || !in)
      throw InputError(
          fmt::format("there is no table of densities '{}'", file_.string()));
    std::string text;
    while (std::getline(in, text)) {
      ++line_;
      const std::string line(trimmed(text));
      if (line.empty() || line.front() == '#')
        continue;
      if (columns_ == 0)
        take_header(line);
      else
        take_line(line);
    }
    if (columns_ == 0)
      complain(expected_header);
    return field(find_axes());
  }

private:
  struct Column {
    std::size_t number = 0;
    double factor = 0; ///< to SI; 0: there is no such column
  };

  [[noreturn]] void complain(const std::string &problem) const
  {
    throw InputError(
        fmt::format("{}:{}: {}", file_.string(), std::max(line_, 1u), problem));
  }

  std::optional<double> factor_of(const std::string &field,
                                  const std::string &name,
                                  const Dimension &dimension) const
  {
    try {
      return column_factor(field, name, dimension);
    } catch (const InputError &error) {
      complain(error.what());
    }
  }

  Column find(const std::vector<std::string> &fields,
              const std::string &name,
              const Dimension &dimension) const
  {
    Column column;
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const auto factor = factor_of(fields[k], name, dimension);
      if (factor && column.factor > 0)
        complain("there are two columns '" + name + "'");
      if (factor)
        column = {k, *factor};
    }
    return column;
  }

  void take_header(const std::string &line)
  {
    const auto fields = fields_of(line);
    const Column r = find(fields, "r", dimension::length);
    axes_ = {find(fields, "x", dimension::length),
             find(fields, "y", dimension::length),
             find(fields, "z", dimension::length)};
    density_ = find(fields, "relative_density", dimension::number);
    radial_ = r.factor > 0;
    const bool one_kind = radial_ ? axes_[0].factor + axes_[1].factor == 0
                                  : axes_[0].factor > 0 && axes_[1].factor > 0;
    if (!one_kind || axes_[2].factor == 0 || density_.factor == 0)
      complain(expected_header);
    if (radial_)
      axes_[0] = r;
    columns_ = fields.size();
  }

  double value(const std::vector<std::string> &fields,
               const Column &column) const
  {
    const auto number = number_of(fields[column.number]);
    if (!number)
      complain(fmt::format("'{}': expected a number", fields[column.number]));
    return *number * column.factor;
  }

  void take_line(const std::string &line)
  {
    const auto fields = fields_of(line);
    if (fields.size() != columns_)
      complain(fmt::format("'{}': expected {} values, as in the header, not {}",
                           line,
                           columns_,
                           fields.size()));
    Place place{};
    for (unsigned axis = 0; axis < 3; ++axis)
      if (axes_[axis].factor > 0)
        place[axis] = value(fields, axes_[axis]);
    const double density = value(fields, density_);
    if (!(density > 0 && density < 1))
      complain(fmt::format("'{}': expected a relative density between 0 and 1",
                           fields[density_.number]));
    if (!densities_.emplace(place, density).second)
      complain("the place of '" + line + "' has a density already");
  }

  std::string name(const Place &place) const
  {
    return radial_
               ? fmt::format("r = {:.6g} m, z = {:.6g} m", place[0], place[2])
               : fmt::format("x = {:.6g} m, y = {:.6g} m, z = {:.6g} m",
                             place[0],
                             place[1],
                             place[2]);
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
        complain(fmt::format("expected at least two different values of {}",
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
    return [grid = std::make_shared<const Grid>(places, table),
            reader = *this,
            axes](const dealii::Tensor<1, 3> &place) {
      return reader.interpolate(*grid, axes, place);
    };
  }

  double density_at(const Place &place) const
  {
    const auto found = densities_.find(place);
    if (found == densities_.end())
      complain("there is no density at " + name(place) +
               "; expected one at every place of a rectilinear grid");
    return found->second;
  }

  double interpolate(const Grid &grid,
                     const Axes &axes,
                     const dealii::Tensor<1, 3> &at) const
  {
    const Place place = radial_ ? Place{std::hypot(at[0], at[1]), 0, at[2]}
                                : Place{at[0], at[1], at[2]};
    for (unsigned axis = 0; axis < 3; ++axis)
      if (place[axis] < axes[axis].front() || place[axis] > axes[axis].back())
        throw InputError(fmt::format("{}: the point at {} is outside the grid",
                                     file_.string(),
                                     name(place)));
    return grid.value({place[0], place[1], place[2]});
  }

  std::filesystem::path file_;
  unsigned line_ = 0;
  std::size_t columns_ = 0; ///< 0: the header has not been read
  std::array<Column, 3> axes_;
  Column density_;
  bool radial_ = false;
  std::map<Place, double> densities_;
};
} // namespace

DensityField read_density_grid(const std::filesystem::path &file)
{
  return DensityGridReader(file).read();
}
} // namespace tamp::apps
