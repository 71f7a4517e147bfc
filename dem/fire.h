// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_fire_h
#define dem_fire_h

#include <dem/kernel/grain_motion.h>

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
  /// The next move along the forces whose sums are given; `back` is left to the
  /// caller.
  RelaxationMove next(const RelaxationSums &sums);

private:
  static constexpr double first_mixing = 0.1;

  double step_ = 0.7, mixing_ = first_mixing;
  unsigned downhill_ = 0;
};
} // namespace tamp::dem

#endif
