// SPDX-License-Identifier: BSD-3-Clause
#include <apps/die/die_maps.h>
#include <apps/output/section_map.h>

namespace tamp::apps
{
namespace
{
double density(const fem::Response &response)
{
  return response.relative_density;
}

// In the section the axes are r, hoop, z.
double axial_stress(const fem::Response &response)
{
  return 0 - response.stress[2][2] / 1e6;
}

double hoop_stress(const fem::Response &response)
{
  return 0 - response.stress[1][1] / 1e6;
}

// The mean of each element's four parts, for stresses: they are most accurate
// at the centre of a bilinear element (J. Barlow, 1976) and alternate about it
// in large gradients.
std::vector<ValueQuadrilateral> with_means(std::vector<ValueQuadrilateral> map)
{
  for (std::size_t part = 0; part + 3 < map.size(); part += 4) {
    double mean = 0;
    for (std::size_t quarter = 0; quarter < 4; ++quarter)
      mean += map[part + quarter].value / 4;
    for (std::size_t quarter = 0; quarter < 4; ++quarter)
      map[part + quarter].value = mean;
  }
  return map;
}
} // namespace

void DieMaps::take_peak(const fem::Mesh &mesh, const fem::DieModel &model)
{
  peak_density_ = section_map(mesh, model, density);
}

void DieMaps::take_end(const fem::Mesh &mesh, const fem::DieModel &model)
{
  density_ = section_map(mesh, model, density);
  axial_stress_ = with_means(section_map(mesh, model, axial_stress));
  hoop_stress_ = with_means(section_map(mesh, model, hoop_stress));
}

void DieMaps::write(const std::filesystem::path &folder) const
{
  write_map(folder / "density_map.dat", peak_density_);
  write_map(folder / "final_density_map.dat", density_);
  write_map(folder / "final_axial_stress.dat", axial_stress_);
  write_map(folder / "final_hoop_stress.dat", hoop_stress_);
}

void DieMaps::pack(std::vector<char> &bytes) const
{
  fem::append_state(bytes, peak_density_);
}

void DieMaps::go_on(fem::StateBytes &stored)
{
  stored.take(peak_density_);
}
} // namespace tamp::apps
