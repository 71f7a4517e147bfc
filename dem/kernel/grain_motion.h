// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_kernel_grain_motion_h
#define dem_kernel_grain_motion_h

#include <dem/grains.h>

#include <cstddef>

namespace tamp::dem
{
// How grains move, in rows of eight numbers as in GrainRow: those of the
// translation, 0, those of radius x rotation, 0. Always in double precision.

/// A grain that relaxes towards equilibrium.
struct alignas(64) RelaxingGrain {
  double position[8]; ///< since the start of the increment [m]
  double velocity[8]; ///< per unit of the step [m]
  double listed[8];   ///< position when the pairs were listed; 0 from 4 on [m]
  /// 1 / mass of translation, 0, 1 / mass of rotation, 0.
  double mobility[8];
};

/// What steers a relaxation.
struct RelaxationSums {
  double power = 0;     ///< sum of force x velocity
  double kinetic = 0;   ///< sum of mass x velocity^2
  double steepness = 0; ///< sum of force^2 / mass
  double force = 0;     ///< sum of |F| over the grains [N]
  double torque = 0;    ///< sum of |torque / radius| over the grains [N]
};

/// One move of a relaxation: position += retreat velocity; velocity = keep
/// velocity + push force / mass; position += step velocity.
struct RelaxationMove {
  double retreat, keep, push, step;
};

/// A grain that moves in time.
struct alignas(64) MovingGrain {
  double velocity[8]; ///< fluctuation, 0, radius x spin, 0 [m/s]
  /// Since the pairs were listed, less the box; only the first three [m].
  double moved[8];
  // Of translation and of radius x spin:
  double damping[2]; ///< force per velocity [kg/s]
  double gain[2];    ///< velocity gained per force in a step [s/kg]
};

/// One time step of all grains.
struct TimeStep {
  double length;            ///< [s]
  double local_damping = 0; ///< share taken off each force [-]
  double stretch[9];        ///< of the box in the step, row by row [-]
};

/// What a time step tells.
struct TimeStepSums {
  double fastest2 = 0; ///< no square of a velocity is larger [m2/s2]
  double heat = 0;     ///< taken by damping in the step [J]
};

/// The loops over grains, T is that of the rows.
template <class T>
struct GrainLoops {
  /// Sums of the forces in the rows on the way of the grains.
  using Survey = RelaxationSums (*)(const GrainRow<T> *rows,
                                    const RelaxingGrain *grains,
                                    std::size_t count);
  /// Moves the grains, writes it into the rows, and takes the forces out of
  /// them. Returns the largest square
  /// of a displacement since the pairs were listed [m2].
  using Relax = double (*)(const RelaxationMove &move,
                           GrainRow<T> *rows,
                           RelaxingGrain *grains,
                           std::size_t count);
  /// Kicks the grains by the forces in the rows, which it takes out, and moves
  /// them.
  using Advance = TimeStepSums (*)(const TimeStep &step,
                                   GrainRow<T> *rows,
                                   MovingGrain *grains,
                                   std::size_t count);
  Survey survey;
  Relax relax;
  Advance advance;
};
} // namespace tamp::dem

#endif
