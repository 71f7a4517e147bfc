// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_small_probes_h
#define fem_small_probes_h

#include <fem/material_points.h>

#include <functional>
#include <optional>
#include <vector>

namespace tamp::fem
{
/// Isotropic elasticity of a material point in some state.
struct MeasuredModuli {
  double pressure = 0; ///< of the state, compression positive [Pa]
  double bulk = 0;     ///< K [Pa]
  double shear = 0;    ///< G [Pa]

  double youngs_modulus() const
  {
    return 9 * bulk * shear / (3 * bulk + shear);
  }
  double poissons_ratio() const
  {
    return (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
  }
};

/// Measures the moduli of point 0, which is in the same state afterwards. K:
/// the point is unloaded by this volumetric strain and loaded again. G: from
/// there it is strained at constant volume by this equivalent strain, against
/// its deviatoric stress, and back, along the axes xx, yy, zz and in the shears
/// yz, xz, xy; the mean of the moduli in these directions is that of the
/// isotropic body next to the point's symmetric stiffness. Every modulus is the
/// mean of the way out and the way back. None if the point fails.
/// @param strain  small, 1e-4 say [-]
/// @param turn    is called where the direction turns; may be empty
std::optional<MeasuredModuli>
measure_moduli(MaterialPoints &points,
               double strain,
               const std::function<void()> &turn = {});

/// Moduli between and beyond measured ones: powers of the pressure between
/// neighbours, constant outside.
class ModuliOverPressure
{
public:
  /// @param measured  at least one, in any order, all of positive values
  explicit ModuliOverPressure(std::vector<MeasuredModuli> measured);

  MeasuredModuli at(double pressure) const;

private:
  std::vector<MeasuredModuli> measured_; ///< by rising pressure
};
} // namespace tamp::fem

#endif
