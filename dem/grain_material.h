// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_grain_material_h
#define dem_grain_material_h

namespace tamp::dem
{
/// The solid that grains are made of.
struct GrainMaterial {
  double youngs_modulus = 70e9; ///< E [Pa]
  double poissons_ratio = 0.3;  ///< nu [-]
  double density = 2650;        ///< of the solid [kg/m3]

  /// Throws std::invalid_argument naming the first value that is not
  /// physical.
  void check() const;

  double shear_modulus() const
  {
    return youngs_modulus / (2 * (1 + poissons_ratio));
  }
  /// E* of two grains of this material in contact [Pa].
  /// Source: Johnson (1985), ch. 4: 1/E* = 2 (1 - nu^2) / E.
  double effective_modulus() const
  {
    return youngs_modulus / (2 * (1 - poissons_ratio * poissons_ratio));
  }
  /// G* of two grains of this material in contact [Pa], such that the
  /// tangential stiffness is 8 G* a.
  /// Source: Mindlin (1949); Johnson (1985), ch. 7: 1/G* = 2 (2 - nu) / G.
  double effective_shear_modulus() const
  {
    return shear_modulus() / (2 * (2 - poissons_ratio));
  }
  bool operator==(const GrainMaterial &) const = default;
};

enum class NormalLaw { hertz, thornton_ning };
enum class TangentialLaw { none, mindlin };

/// How two grains push and rub.
struct ContactModel {
  NormalLaw normal_law = NormalLaw::thornton_ning;
  TangentialLaw tangential_law = TangentialLaw::mindlin;
  double friction_coefficient = 0.3; ///< mu [-]
  /// p_y, where the contact pressure is cut off [Pa]; Thornton-Ning only.
  double limiting_pressure = 0.5e9;

  /// Throws std::invalid_argument naming the first value that is not
  /// physical.
  void check() const;
  bool operator==(const ContactModel &) const = default;
};
} // namespace tamp::dem

#endif
