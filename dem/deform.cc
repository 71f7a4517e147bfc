// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/deform.h>
#include <dem/dynamics.h>
#include <dem/quasi_static.h>
#include <dem/relattice.h>
#include <dem/unit_cell.h>
#include <dem/value_check.h>

namespace tamp::dem
{
void Driving::check() const
{
  const Positive positive;
  positive(quasi_static.unbalance_tolerance, "unbalance tolerance");
  positive(quasi_static.maximum_strain_increment, "maximum strain increment");
  positive(dynamics.strain_rate, "strain rate");
  positive(dynamics.density_scaling, "density scaling");
  positive(dynamics.time_step_fraction, "time step fraction");
  if (dynamics.time_step_fraction > 1)
    refuse("time step fraction", dynamics.time_step_fraction, "at most 1");
  if (!(dynamics.global_damping >= 0))
    refuse("global damping", dynamics.global_damping, "zero or positive");
  if (!(dynamics.local_damping >= 0 && dynamics.local_damping < 1))
    refuse("local damping", dynamics.local_damping, "from 0 to below 1");
}

CellAnswer deform(UnitCell &cell,
                  const Stretch &stretch,
                  const Driving &driving,
                  WarmGuess *guess)
{
  CellLaws(cell).check(cell);
  relattice(cell);
  return driving.method == Method::quasi_static
             ? deform_quasi_static(cell,
                                   stretch,
                                   driving.quasi_static,
                                   driving.arithmetic,
                                   guess)
             : deform_by_dynamics(
                   cell, stretch, driving.dynamics, driving.arithmetic);
}
} // namespace tamp::dem
