// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_fkm_gurson_h
#define fem_laws_fkm_gurson_h

#include <fem/laws/fkm_gurson_surface.h>
#include <fem/material_points.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tamp::fem
{
/// Constants of the law of Fleck, Kuhn and McMeeking and of Gurson for a powder
/// of ductile spheres. The defaults are of the order of annealed copper.
struct FkmGursonParameters {
  double solid_yield_stress = 100e6;      ///< sigma_0 [Pa]
  double solid_youngs_modulus = 120e9;    ///< E_s [Pa]
  double solid_poissons_ratio = 0.34;     ///< nu, at all densities [-]
  double elastic_exponent = 7;            ///< b in E = E_s exp(-b (1 - D)) [-]
  double random_packing_density = 0.64;   ///< D_0 [-]
  double initial_relative_density = 0.66; ///< [-]
  double yield_floor = 1e-3;              ///< least p_y of FKM over sigma_0 [-]
  double vertex_rounding = 0.01;          ///< a / p_y, see FkmGursonSurface [-]
  /// Largest estimated error of stress over the hydrostatic yield pressure in a
  /// part of an increment [-].
  double integration_tolerance = 2e-5;

  /// Throws std::invalid_argument naming the first value that is not possible.
  void check() const;
};

/// Yield of a metal powder from random packing to full density, at finite
/// strain through Corotation: the surface of Fleck, Kuhn and McMeeking (1992)
/// for relative densities D up to 0.77, that of Gurson (1977) from 0.90 on, in
/// between their weighted sum (after Redanz 1998), here with the weight x^2 (3
/// - 2 x), x from 0 to 1, so that hardening has no jump; see FkmGursonSurface.
/// Flow is normal to the surface. The only hardening variable is D, here that
/// of the stress-free powder:
///
///   d D / D = d eps_v^pl,
///   p_y = 2.97 D^2 (D - D_0) / (1 - D_0) sigma_0.
///
/// A powder looser than random packing has no strength in this theory; it is
/// given the small one p_y = yield_floor sigma_0, which goes over smoothly into
/// the formula within 2e-3 above D_0 for the default. Such a powder compacts
/// until it carries. The solid does not harden.
///
/// Elasticity is isotropic, d sigma = C(D) d eps^el, with E = E_s exp(-b (1 -
/// D)) (R. M. Spriggs 1961) and nu constant. Integration: see PlasticPath; the
/// tangent is the derivative of the algorithm.
///
/// `doubtful` says that D of the stress-free powder is below D_0. An increment
/// that is impossible, larger than 1 in logarithmic strain, or cannot be
/// integrated fails and leaves the state as it was.
class FkmGurson
{
public:
  static constexpr std::string_view name = "FKM-Gurson";
  /// Pure FKM up to the first, pure Gurson from the second relative density.
  static constexpr double blend_begin = 0.77, blend_end = 0.90;

  struct State {
    dealii::SymmetricTensor<2, 3> stress; ///< Cauchy, tension positive [Pa]
    double relative_density = 0;          ///< elastic strain included [-]
    double porosity = 0;        ///< f = 1 - D without elastic strain [-]
    double plastic_shear = 0;   ///< sum of sqrt(2/3 de:de), de deviatoric [-]
    std::uint32_t yielding = 0; ///< 1 if the last increment ended plastic
    std::uint32_t reserved = 0; ///< zero; makes the bytes of a state definite
  };

  /// Throws what FkmGursonParameters::check() throws.
  explicit FkmGurson(const FkmGursonParameters &parameters = {});

  /// Free of stress, at the initial density.
  State initial_state() const;
  Response respond(const State &old,
                   State &now,
                   const Deformation &deformation,
                   Want want) const;

  /// What a state holds for output, strains since the start of the powder.
  static std::vector<Variable> variables();
  void variables_of(const State &state, std::span<double> values) const;

  /// The surface at a porosity between 0 and 1.
  FkmGursonSurface<double> surface(double porosity) const;

  const FkmGursonParameters &parameters() const { return parameters_; }

private:
  FkmGursonParameters parameters_;
};
} // namespace tamp::fem

#endif
