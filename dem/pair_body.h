// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_pair_body_h
#define dem_pair_body_h

#include <dem/grain_material.h>
#include <dem/laws/pair_law.h>

namespace tamp::dem
{
/// A sphere, or a wall that does not move, whose radius and mass are infinite.
struct Body {
  double radius;                    ///< [m]
  double mass;                      ///< [kg]
  Triple<double> place{0, 0, 0};    ///< of the centre; of a point of a wall [m]
  Triple<double> velocity{0, 0, 0}; ///< [m/s]
  Triple<double> spin{0, 0, 0};     ///< [rad/s]

  static Body grain(double radius, const GrainMaterial &material);
  /// A plane across the axis z.
  static Body wall();
  bool is_wall() const;
  /// Of translation and rotation [J].
  double kinetic_energy() const;
};

/// The shape of two grains, or of a grain and a wall: then R* and m* are radius
/// and mass of the grain, and the sum of the radii is that with a grain of the
/// same size.
PairShape<double> shape_of(const Body &first, const Body &second);

/// A wall that gives way nowhere.
GrainMaterial rigid_wall();
/// A wall that never yields.
/// @param youngs_modulus  E [Pa]
/// @param poissons_ratio  nu [-]
GrainMaterial elastic_wall(double youngs_modulus, double poissons_ratio);
} // namespace tamp::dem

#endif
