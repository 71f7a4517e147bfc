// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_grain_material_h
#define dem_grain_material_h

#include <vector>

namespace tamp::dem
{
/// A limiting contact pressure that holds at a relative density of the cell.
struct PressureAtDensity {
  double relative_density;  ///< of the cell [-]
  double limiting_pressure; ///< p_y [Pa]

  bool operator==(const PressureAtDensity &) const = default;
};

/// The solid that grains are made of.
struct GrainMaterial {
  double youngs_modulus = 70e9; ///< E [Pa]
  double poissons_ratio = 0.3;  ///< nu [-]
  double density = 2650;        ///< of the solid [kg/m3]
  /// p_y, where the pressure in a contact is cut off [Pa]; laws with plasticity
  /// only.
  double limiting_pressure = 0.5e9;
  /// p_y adjusted to the density of the cell, in place of limiting_pressure if
  /// there are any: ln p_y is linear between rising densities, constant
  /// outside. A fit to a measured curve, no property of a solid. Law
  /// thornton_ning_adjusted only.
  std::vector<PressureAtDensity> adjusted_pressures = {};

  /// Throws std::invalid_argument naming the first value that is not
  /// physical.
  void check() const;

  /// The material in a cell of this density: p_y is that which holds there, and
  /// there is no other.
  GrainMaterial at_density(double relative_density) const;

  double shear_modulus() const
  {
    return youngs_modulus / (2 * (1 + poissons_ratio));
  }
  bool operator==(const GrainMaterial &) const = default;
};

/// What the contact of two materials is made of.
struct PairMaterial {
  double effective_modulus;       ///< E* [Pa]
  double effective_shear_modulus; ///< G*, such that k_t = 8 G* a [Pa]
  double limiting_pressure;       ///< p_y [Pa]
};

/// The properties of a contact between grains of two materials, the same or
/// not: 1/E* = sum (1 - nu^2) / E, 1/G* = sum (2 - nu) / G. The softer material
/// yields first: p_y is the smaller of the two.
/// Source: Johnson (1985), ch. 4 and 7; Mindlin (1949).
PairMaterial pair_material(const GrainMaterial &first,
                           const GrainMaterial &second);

enum class NormalLaw {
  hertz,
  thornton_ning,
  jkr,
  thornton_ning_jkr, ///< Thornton-Ning with adhesion
  storakers,
  mdr,
  thornton_ning_adjusted ///< Thornton-Ning under a p_y that changes
};
enum class TangentialLaw { none, mindlin, mindlin_deresiewicz };
enum class RollingLaw { none, epsd };

/// How two grains push, rub and roll.
struct ContactModel {
  NormalLaw normal_law = NormalLaw::thornton_ning;
  TangentialLaw tangential_law = TangentialLaw::mindlin;
  RollingLaw rolling_law = RollingLaw::none;
  double friction_coefficient = 0.3;         ///< mu [-]
  double work_of_adhesion = 0;               ///< Gamma [J/m2]
  double rolling_friction_coefficient = 0.1; ///< mu_r [-]
  /// e of an impact, by viscous contact damping; 1 is without [-].
  double restitution_coefficient = 1;
  /// psi_b, free share of its surface below which a grain responds in bulk;
  /// mdr only [-].
  double bulk_onset = 0.5;

  /// Do grains that touch pull, too?
  bool adheres() const;
  /// Throws std::invalid_argument naming the first value that is not
  /// physical.
  void check() const;
  bool operator==(const ContactModel &) const = default;
};
} // namespace tamp::dem

#endif
