// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_fire_h
#define dem_fire_h

#include <cstddef>
#include <span>
#include <vector>

namespace tamp::dem
{
/// Fast inertial relaxation: damped motion downhill whose velocity is turned
/// towards the force, with a step that grows while it goes well. Masses are
/// chosen by the caller so that a time step of 1 suits every degree of freedom.
/// Source: Bitzek et al. (2006), Phys. Rev. Lett. 97:170201; half step back on
/// uphill motion: Guénolé et al. (2020), Comput. Mater. Sci. 175:109584.
class Fire
{
public:
  explicit Fire(std::vector<double> mass);

  /// One move of all positions along the forces (same length as the masses).
  void move(std::span<double> position, std::span<const double> force);

private:
  std::vector<double> mass_, velocity_;
  double step_, mixing_;
  unsigned downhill_ = 0;
};
} // namespace tamp::dem

#endif
