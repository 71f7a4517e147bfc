// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/unit_cell.h>

namespace tamp::dem
{
CellLaws::CellLaws(const UnitCell &cell) : species_(cell.species)
{
  for (std::size_t b = 0; b < cell.materials.size(); ++b)
    for (std::size_t a = 0; a <= b; ++a)
      laws_.push_back(
          pair_laws(cell.contact, cell.materials[a], cell.materials[b]));
}
} // namespace tamp::dem
