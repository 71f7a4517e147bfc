// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_laws.h>
#include <dem/mixed_control.h>
#include <dem/mixed_search.h>
#include <dem/mixed_servo.h>
#include <dem/relattice.h>
#include <dem/six.h>
#include <dem/stretch.h>
#include <dem/unit_cell.h>
#include <dem/value_check.h>

#include <algorithm>
#include <cmath>

namespace tamp::dem
{
void MixedControl::check() const
{
  const Positive positive;
  positive(accuracy, "accuracy of controlled stresses");
  positive(unbalance, "unbalance of controlled stresses");
  for (const ComponentControl &component : components)
    if (!std::isfinite(component.value))
      refuse("controlled component", component.value, "a finite number");
}

MixedAnswer deform_mixed(UnitCell &cell,
                         const MixedControl &control,
                         const Driving &driving)
{
  control.check();
  driving.check();
  CellLaws(cell).check(cell);
  Six strain;
  bool strains_only = true;
  for (int k = 0; k < 6; ++k) {
    strain[k] = control.components[k].value;
    strains_only = strains_only &&
                   control.components[k].kind == ComponentControl::Kind::strain;
  }
  if (strains_only) {
    MixedAnswer result{from_six(strain), exponential(from_six(strain)), {}};
    result.cell = deform(cell, result.stretch, driving);
    return result;
  }
  relattice(cell);
  return driving.method == Method::quasi_static
             ? search_mixed(cell, control, driving)
             : servo_mixed(cell, control, driving.dynamics, driving.arithmetic);
}
} // namespace tamp::dem
