// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_drucker_prager_cap_h
#define fem_laws_drucker_prager_cap_h

#include <fem/laws/cap_surface.h>
#include <fem/laws/density_table.h>
#include <fem/laws/elastic.h>
#include <fem/laws/mcc_ph102.h>
#include <fem/material_points.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tamp::fem
{
/// Constants of the density-dependent Drucker-Prager cap model. The defaults
/// are microcrystalline cellulose Avicel PH-102, see mcc_ph102.h.
///
/// All tables are read at the *plastic* density D_pl = D_ref exp(eps), the
/// density that would remain after elastic unloading; eps is the plastic
/// volumetric strain, positive in compaction, and D_ref the density at which
/// the hardening table has its zero. A sample that starts at D_0 starts with
/// eps = ln(D_0 / D_ref) and so with the p_b that the table gives for D_0: the
/// start density and the table cannot disagree.
struct DruckerPragerCapParameters {
  PorousElasticity elasticity{mcc_ph102::youngs_modulus(),
                              mcc_ph102::poissons_ratio()};
  DensityTable cohesion = mcc_ph102::cohesion();             ///< d [Pa]
  DensityTable friction_angle = mcc_ph102::friction_angle(); ///< beta [rad]
  DensityTable eccentricity = mcc_ph102::eccentricity();     ///< R_c [-]
  /// p_b [Pa] over eps [-], not decreasing.
  DensityTable hardening = mcc_ph102::hardening();
  double reference_density = mcc_ph102::reference_density;      ///< D_ref [-]
  double initial_relative_density = mcc_ph102::initial_density; ///< D_0 [-]
  double transition = 0;                 ///< alpha [-], 0 to 0.1
  Dilation dilation = Dilation::bounded; ///< in shear failure
  /// No part is a larger strain than this, but for the mixture with smaller
  /// parts up to twice of it; norm [-].
  double maximum_strain_increment = 1e-2;
  /// A part is halved until the stresses of one backward Euler step and of two
  /// differ by less than this, relative [-]. The answer is more accurate.
  double integration_tolerance = 1.5e-4;

  /// Throws std::invalid_argument naming the first value that is not possible.
  void check() const;
};

/// Modified Drucker-Prager cap plasticity for powders, with every constant a
/// function of density (Drucker, Gibson and Henkel 1957; Abaqus manual;
/// Cunningham et al. 2004, Sinka et al. 2003, Han et al. 2008 for the
/// dependence on density). See CapSurface for surfaces and flow. Plastic
/// compaction hardens, plastic dilation softens, along the same tables.
///
/// Integration, in the frame that does not turn (dF = R U, strain ln U). The
/// elastic way to the surface is exact; what is left is integrated in parts. A
/// part is a backward Euler step with the elastic moduli of its start: p_b, d,
/// beta and R_c are those at its end, and the stress lies on the surface they
/// make. The return has two unknowns, found by Newton's method; if that fails
/// it reduces to one equation in the plastic compaction whose root is bracketed
/// on each branch. One step over a part and two over its halves give an
/// estimate of error and, extrapolated and drawn to the surface, an answer of
/// second order. A part is halved, up to 10 times, until the estimate meets its
/// tolerance; what does not is `doubtful`, and a return that fails even then is
/// `failed` with the state as before. For cellulose in increments of 1e-2 the
/// stress is within 1e-4 of a fine explicit integration on every surface.
///
/// Where the estimate is between one and two tolerances the answers of the part
/// and of its halves are mixed, with a weight that is a smooth function of the
/// estimate. So the stress is a continuous function of the strain, whatever
/// parts are taken, and the tangent is its derivative: Newton's method
/// converges quadratically. The tangent is not symmetric in general. At the
/// apex with q = 0, where the surface has a corner, it is the mean of the
/// derivatives to both sides.
///
/// `doubtful` says also that a table was read outside its rows.
class DruckerPragerCap
{
public:
  static constexpr std::string_view name = "Drucker-Prager cap";

  /// Where the last part of an increment ended.
  enum class Surface : std::uint32_t { none, shear, transition, cap, apex };

  struct State {
    dealii::SymmetricTensor<2, 3> stress; ///< Cauchy, tension positive [Pa]
    double relative_density = 0;          ///< [-]
    double plastic_compaction = 0;        ///< eps, zero at D_ref [-]
    double plastic_shear = 0; ///< sum of sqrt(2/3 de:de), de deviatoric [-]
    Surface surface = Surface::none;
    std::uint32_t outside_tables = 0; ///< 1 if a table was left
  };

  /// Throws what DruckerPragerCapParameters::check() throws.
  explicit DruckerPragerCap(const DruckerPragerCapParameters &parameters = {});

  /// Free of stress, at the initial density.
  State initial_state() const;
  Response respond(const State &old,
                   State &now,
                   const Deformation &deformation,
                   Want want) const;

  /// What a state holds for output, strains since the start of the powder.
  static std::vector<Variable> variables();
  void variables_of(const State &state, std::span<double> values) const;

  /// The surface of a point with this plastic volumetric strain.
  CapSurface<double> surface(double plastic_compaction) const;

  /// How far a state is outside its surface, over p_b - p_a + A: negative
  /// inside [-].
  double yield(const State &state) const;

  const DruckerPragerCapParameters &parameters() const { return parameters_; }

private:
  DruckerPragerCapParameters parameters_;
};

/// p = -tr(sigma) / 3, compression positive [Pa].
double pressure(const dealii::SymmetricTensor<2, 3> &stress);
/// q = sqrt(3/2 s : s) [Pa].
double deviatoric_stress(const dealii::SymmetricTensor<2, 3> &stress);
} // namespace tamp::fem

#endif
