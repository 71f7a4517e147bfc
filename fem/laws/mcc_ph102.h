// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_laws_mcc_ph102_h
#define fem_laws_mcc_ph102_h

#include <fem/laws/density_table.h>

/// Density-dependent Drucker-Prager cap tables of microcrystalline cellulose
/// Avicel PH-102, alpha = 0, K = 1.
///
/// Source: retyped from the public repository
/// taha-re/manuscript-data-density-dependent-friction-tableting (commit
/// 83e1922), which credits the tables to Panos (2007). Model tables, not raw
/// tests. In the source entries of the hardening table up to D = 0.93 are given
/// by density; here they are converted by eps = ln(D / 0.3).
namespace tamp::fem::mcc_ph102
{
/// The density at which the plastic volumetric strain of hardening() is zero
/// [-].
inline constexpr double reference_density = 0.3;

/// Where the die case of the same source starts [-].
inline constexpr double initial_density = 0.3411;

/// Young's modulus [Pa] over relative density [-], 0.30 to 0.98.
DensityTable youngs_modulus();
/// Poisson's ratio [-] over relative density [-], 0.30 to 0.98.
DensityTable poissons_ratio();
/// Cohesion d in the p-q plane [Pa] over relative density [-], 0.30 to 0.99.
DensityTable cohesion();
/// Friction angle beta in the p-q plane [rad] over relative density [-], 0.30
/// to 0.99.
DensityTable friction_angle();
/// Cap eccentricity R [-] over relative density [-], 0.30 to 0.99.
DensityTable eccentricity();
/// Hydrostatic yield pressure p_b [Pa] over plastic volumetric strain [-], 0 to
/// 1.203; above, the last line goes on, which stops compaction close to D = 1.
DensityTable hardening();
} // namespace tamp::fem::mcc_ph102

#endif
