// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/agcusnin.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace tamp::fem::agcusnin
{
namespace
{
constexpr double last_density = 0.90;
constexpr double degree = std::numbers::pi / 180;

/// A line from the first density to the last.
DensityTable
line(const std::string &name, const double first, const double last)
{
  return DensityTable({{initial_density, last_density}, {first, last}}, name);
}

/// A function of density in rows 0.02 apart.
template <class Function>
DensityTable rows(const std::string &name, const Function &value)
{
  TableRows rows;
  for (int percent = 42; percent <= 90; percent += 2) {
    rows.x.push_back(percent / 100.);
    rows.y.push_back(value(rows.x.back()));
  }
  return DensityTable(rows, name);
}

/// What lies on the line from the first density to the last.
auto between(const double first, const double last)
{
  return [=](const double density) {
    return first + (last - first) * (density - initial_density) /
                       (last_density - initial_density);
  };
}
} // namespace

DruckerPragerCapParameters parameters()
{
  DruckerPragerCapParameters result;
  result.elasticity = {line("Young's modulus", 1.076e9, 49.2e9),
                       line("Poisson's ratio", 0.068, 0.155)};
  result.cohesion = rows("cohesion", [](const double density) {
    return 24180.7 * std::exp(13.07 * (density - initial_density));
  });
  result.friction_angle =
      rows("friction angle", between(71.12 * degree, 69.00 * degree));
  result.eccentricity = rows("cap eccentricity", between(0.381, 0.524));
  TableRows hardening{
      {0, 0.351, 0.420, 0.471, 0.555, 0.616, 0.682, 0.771, 0.795},
      {0.433, 19.4, 27.6, 37.8, 59.2, 77.6, 101, 147, 216}};
  for (double &pressure : hardening.y)
    pressure *= 1e6;
  result.hardening = DensityTable(hardening,
                                  "hydrostatic yield pressure",
                                  DensityTable::Shape::increasing,
                                  DensityTable::Above::extend);
  result.reference_density = initial_density;
  result.initial_relative_density = initial_density;
  result.transition = 0.02;
  result.dilation = Dilation::bounded;
  return result;
}
} // namespace tamp::fem::agcusnin
