// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die_maps.h>

#include <array>
#include <cmath>

namespace tamp::apps
{
namespace
{
double density(const fem::Response &response)
{
  return response.relative_density;
}

// Of an axisymmetric point the axes are r, hoop, z.
double axial_stress(const fem::Response &response)
{
  return 0 - response.stress[2][2] / 1e6;
}

double hoop_stress(const fem::Response &response)
{
  return 0 - response.stress[1][1] / 1e6;
}
} // namespace

std::vector<ValueQuadrilateral>
point_map(const fem::DieModel &model,
          const std::function<double(const fem::Response &)> &value)
{
  std::vector<double> r, z, values;
  for (const auto &position : model.point_positions()) {
    r.push_back(position[0]);
    z.push_back(position[2]);
  }
  for (const fem::Response &response : model.responses())
    values.push_back(value(response));
  std::vector<ValueQuadrilateral> map;
  for (std::size_t point = 0; point + 3 < values.size(); point += 4) {
    // Place of (x, y) in [-1, 1]^2 by the points, which sit at +-1/sqrt(3).
    const auto place = [&](double x, double y) {
      const double a = 0.5 * (1 + std::sqrt(3.) * x);
      const double b = 0.5 * (1 + std::sqrt(3.) * y);
      const auto mean = [&](const std::vector<double> &of) {
        return (1 - b) * ((1 - a) * of[point] + a * of[point + 1]) +
               b * ((1 - a) * of[point + 2] + a * of[point + 3]);
      };
      return std::array<double, 2>{mean(r), mean(z)};
    };
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      const double x = quarter % 2 == 0 ? -1 : 0;
      const double y = quarter / 2 == 0 ? -1 : 0;
      map.push_back(
          {{place(x, y), place(x + 1, y), place(x + 1, y + 1), place(x, y + 1)},
           values[point + quarter]});
    }
  }
  return map;
}
std::vector<ValueQuadrilateral>
element_map(const fem::DieModel &model,
            const std::function<double(const fem::Response &)> &value)
{
  std::vector<ValueQuadrilateral> map = point_map(model, value);
  for (std::size_t part = 0; part + 3 < map.size(); part += 4) {
    double mean = 0;
    for (std::size_t quarter = 0; quarter < 4; ++quarter)
      mean += map[part + quarter].value / 4;
    for (std::size_t quarter = 0; quarter < 4; ++quarter)
      map[part + quarter].value = mean;
  }
  return map;
}

void DieMaps::take_peak(const fem::DieModel &model)
{
  peak_density_ = point_map(model, density);
}

void DieMaps::take_end(const fem::DieModel &model)
{
  density_ = point_map(model, density);
  axial_stress_ = element_map(model, axial_stress);
  hoop_stress_ = element_map(model, hoop_stress);
}

void DieMaps::write(const std::filesystem::path &folder) const
{
  write_map(folder / "density_map.dat", peak_density_);
  write_map(folder / "final_density_map.dat", density_);
  write_map(folder / "final_axial_stress.dat", axial_stress_);
  write_map(folder / "final_hoop_stress.dat", hoop_stress_);
}
} // namespace tamp::apps
