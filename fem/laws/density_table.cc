// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/density_table.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace tamp::fem
{
namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();

[[noreturn]] void
refuse(const std::string &name, const std::size_t row, const std::string &why)
{
  std::ostringstream text;
  text << "table '" << name << "', row " << row + 1 << ": " << why;
  throw std::invalid_argument(text.str());
}

void check(const TableRows &rows,
           const std::string &name,
           const DensityTable::Shape shape)
{
  const auto &[x, y] = rows;
  if (x.size() != y.size() || x.size() < 2) {
    std::ostringstream text;
    text << "table '" << name << "' has " << x.size() << " places and "
         << y.size() << " values; expected as many of both, at least 2";
    throw std::invalid_argument(text.str());
  }
  for (std::size_t row = 0; row < x.size(); ++row) {
    if (!std::isfinite(x[row]) || !std::isfinite(y[row]))
      refuse(name, row, "expected finite numbers");
    if (row == 0)
      continue;
    if (!(x[row] > x[row - 1]))
      refuse(name, row, "expected a place above that of the row before");
    if (shape == DensityTable::Shape::increasing && y[row] < y[row - 1])
      refuse(name, row, "expected a value not below that of the row before");
  }
}
} // namespace

DensityTable::DensityTable(const double constant) : rows_{{0}, {constant}}
{
  if (!std::isfinite(constant))
    throw std::invalid_argument("a constant property has to be finite");
}

DensityTable::DensityTable(TableRows rows,
                           const std::string &name,
                           const Shape shape,
                           const Above above)
    : rows_(std::move(rows)), above_(above)
{
  check(rows_, name, shape);
}

DensityTable::Reading DensityTable::read(const double x) const
{
  constexpr double edge = 1e-9; // rounding of exp(log(density))
  const Line line = this->line(x);
  return {line.at(x),
          line.slope,
          x < first_place() - edge || x > last_place() + edge};
}

DensityTable::Line DensityTable::line(const double x) const
{
  const auto &[place, value] = rows_;
  if (place.size() == 1)
    return {-infinity, infinity, 0, value.front(), 0};
  if (x < place.front())
    return {-infinity, place.front(), place.front(), value.front(), 0};
  if (x >= place.back() && above_ == Above::hold)
    return {place.back(), infinity, place.back(), value.back(), 0};

  const auto next = std::upper_bound(place.begin(), place.end() - 1, x);
  const auto i = static_cast<std::size_t>(next - place.begin());
  const bool last = i + 1 == place.size() && above_ == Above::extend;
  return {place[i - 1],
          last ? infinity : place[i],
          place[i - 1],
          value[i - 1],
          (value[i] - value[i - 1]) / (place[i] - place[i - 1])};
}

double DensityTable::first_place() const
{
  return rows_.x.size() == 1 ? -infinity : rows_.x.front();
}

double DensityTable::last_place() const
{
  return rows_.x.size() == 1 ? infinity : rows_.x.back();
}

double DensityTable::smallest() const
{
  return *std::min_element(rows_.y.begin(), rows_.y.end());
}

double DensityTable::largest() const
{
  return *std::max_element(rows_.y.begin(), rows_.y.end());
}

bool DensityTable::is_increasing() const
{
  return std::is_sorted(rows_.y.begin(), rows_.y.end());
}
} // namespace tamp::fem
