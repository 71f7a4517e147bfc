// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_modified_cam_clay_h
#define fem_laws_modified_cam_clay_h

#include <fem/laws/cam_clay_surface.h>
#include <fem/material_points.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tamp::fem
{
/// Constants of modified Cam-Clay for a powder. With the defaults the
/// hydrostatic yield pressure is within 15 % of that of microcrystalline
/// cellulose (mcc_ph102.h) at relative densities from 0.40 to 0.80, and the
/// bulk modulus is that of the same tables at 0.60.
struct ModifiedCamClayParameters {
  double critical_state_slope = 1.8;        ///< M = q / p at critical state [-]
  double compression_index = 0.45;          ///< lambda [-]
  double swelling_index = 0.08;             ///< kappa [-]
  double poissons_ratio = 0.1;              ///< [-]
  double initial_relative_density = 0.3411; ///< [-]
  double initial_yield_pressure = 1.4e6;    ///< p_c at the initial density [Pa]
  /// Below this pressure the bulk modulus stays as it is there [Pa].
  double floor_pressure = 1e5;
  /// Largest estimated error of stress over p_c in a part of an increment [-].
  double integration_tolerance = 2e-5;

  /// Throws std::invalid_argument naming the first value that is not possible.
  void check() const;
};

/// Modified Cam-Clay (K. H. Roscoe and J. B. Burland 1968; D. Muir Wood, Soil
/// Behaviour and Critical State Soil Mechanics, 1990), at finite strain through
/// Corotation, pressure p positive in compression:
///
///   F = q^2 / M^2 + p (p - p_c), flow normal to it,
///   d p_c / p_c = v / (lambda - kappa) d eps_v^pl,
///   d p = K d eps_v^el, K = v max(p, p_floor) / kappa,
///   d s = 2 G d e^el, G = 3 (1 - 2 nu) / (2 (1 + nu)) K,
///
/// with the specific volume v = 1 + e = 1 / D of the deformed powder. The floor
/// keeps a powder without load from being without stiffness; it starts free of
/// stress and reaches zero stress again. As d v = -v d eps_v, all that concerns
/// volume is integrated exactly, whatever the increment:
///
///   v = v_0 - kappa [psi(p) - psi(p_0)] - (lambda - kappa) ln(p_c / p_c0)
///
/// where psi(p) is ln(p / p_floor) above the floor and p / p_floor - 1 below;
/// so is the elastic part of an increment (G from the secant of p). What is
/// left, the direction of flow, is integrated as PlasticPath says. With a
/// pressure-dependent G at constant Poisson's ratio elasticity does not derive
/// from a potential (M. Zytynski et al. 1978): closed cycles of large elastic
/// strains may create work. The tangent is the derivative of the algorithm.
///
/// Nothing in the law knows of full density: `doubtful` says that the relative
/// density is above 1. An increment that is impossible, larger than 1 in
/// logarithmic strain, or cannot be integrated fails and leaves the state as it
/// was.
class ModifiedCamClay
{
public:
  static constexpr std::string_view name = "modified Cam-Clay";

  struct State {
    dealii::SymmetricTensor<2, 3> stress; ///< Cauchy, tension positive [Pa]
    double relative_density = 0;          ///< D [-]
    double yield_pressure = 0;            ///< p_c [Pa]
    double plastic_compaction = 0;        ///< eps_v^pl since the start [-]
    double plastic_shear = 0;   ///< sum of sqrt(2/3 de:de), de deviatoric [-]
    std::uint32_t yielding = 0; ///< 1 if the last increment ended plastic
    std::uint32_t reserved = 0; ///< zero; makes the bytes of a state definite
  };

  /// Throws what ModifiedCamClayParameters::check() throws.
  explicit ModifiedCamClay(const ModifiedCamClayParameters &parameters = {});

  /// Free of stress, at the initial density.
  State initial_state() const;
  Response respond(const State &old,
                   State &now,
                   const Deformation &deformation,
                   Want want) const;

  /// What a state holds for output, strains since the start of the powder.
  static std::vector<Variable> variables();
  void variables_of(const State &state, std::span<double> values) const;

  CamClaySurface<double> surface(const State &state) const;

  const ModifiedCamClayParameters &parameters() const { return parameters_; }

private:
  ModifiedCamClayParameters parameters_;
};
} // namespace tamp::fem

#endif
