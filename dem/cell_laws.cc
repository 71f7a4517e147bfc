// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/unit_cell.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tamp::dem
{
CellLaws::CellLaws(const UnitCell &cell) : species_(cell.species)
{
  const std::vector<GrainMaterial> materials = cell.materials_now();
  for (std::size_t b = 0; b < materials.size(); ++b)
    for (std::size_t a = 0; a <= b; ++a)
      laws_.push_back(pair_laws(cell.contact, materials[a], materials[b]));
}

void CellLaws::check(const UnitCell &cell) const
{
  check_adjusted(cell.contact, cell.materials);
  const std::vector<double> smallest = smallest_radii(cell);
  for (std::size_t b = 0, kind = 0; b < smallest.size(); ++b)
    for (std::size_t a = 0; a <= b; ++a, ++kind)
      if (std::isfinite(smallest[a] + smallest[b]))
        check_size(laws_[kind], 1 / (1 / smallest[a] + 1 / smallest[b]));
}

std::vector<double> smallest_radii(const UnitCell &cell)
{
  std::vector<double> smallest(cell.materials.size(),
                               std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < cell.size(); ++i) {
    double &radius = smallest[cell.species.empty() ? 0 : cell.species[i]];
    radius = std::min(radius, cell.radius[i]);
  }
  return smallest;
}
} // namespace tamp::dem
