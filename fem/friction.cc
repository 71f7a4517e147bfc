// SPDX-License-Identifier: BSD-3-Clause
#include <fem/friction.h>

namespace tamp::fem
{
DensityTable::Reading FrictionCoefficient::at(double density,
                                              double pressure) const
{
  DensityTable::Reading reading =
      table.read(of == Of::density ? density : pressure);
  if (of != Of::pressure)
    reading.slope = 0;
  return reading;
}
} // namespace tamp::fem
