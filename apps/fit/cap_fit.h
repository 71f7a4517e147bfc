// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_cap_fit_h
#define apps_fit_cap_fit_h

#include <apps/fit/cap_geometry.h>
#include <apps/fit/probe_data.h>
#include <coupling/material_factory.h>

#include <array>
#include <string>
#include <vector>

namespace tamp::apps
{
/// How a branch of a scan tells yield: the numbers of the column `criterion`.
enum class YieldCriterion { strain, work, peak };

/// The constants of a Drucker-Prager cap at one density.
struct CapValues {
  double cohesion = 0;       ///< d [Pa]
  double friction_angle = 0; ///< beta in the p-q plane [rad]
  double eccentricity = 0;   ///< R [-]
  double yield_pressure = 0; ///< p_b [Pa]
  double youngs_modulus = 0; ///< E [Pa]
  double poissons_ratio = 0; ///< nu [-]
};

/// A density at which all constants were found.
struct CapLevel {
  double density = 0;        ///< of the unloaded powder [-]
  double loaded_density = 0; ///< on the main path [-]
  unsigned replicas = 0;
  CapValues value;     ///< as in the tables of the law
  CapValues mean;      ///< of the replicas, before smoothing
  CapValues deviation; ///< of one replica, with N - 1; zero of a single one
  double shear_residual = 0; ///< rms of shear points about the line [-]
  /// Standard error of d from the scatter of the shear points of all replicas
  /// about their line [Pa]; zero if they are too few.
  double cohesion_error = 0;
  /// The shear points begin so far from the axis that d is extrapolated.
  bool cohesion_extrapolated = false;
  /// Plastic compaction over shear measured along the uniaxial path [-].
  double plastic_ratio = 0;
  /// R if that ratio is taken as 3/2: no lateral plastic strain [-].
  double rigid_eccentricity = 0;
  /// p_b from the uniaxial path alone [Pa].
  double uniaxial_yield_pressure = 0;
  /// beta by each criterion [rad]; zero without points.
  std::array<double, 3> angle_by_criterion{};
  /// Shear points and points on the cap, of the criterion in use.
  std::vector<StressPoint> shear_points, cap_points;
  StressPoint uniaxial; ///< mean state on the uniaxial path
};

struct HardeningRow {
  double density = 0;  ///< of the unloaded powder [-]
  double pressure = 0; ///< p_b [Pa]
};

/// Tables over density and how they were found.
struct CapFit {
  Loading hardening_from = Loading::uniaxial;
  std::vector<CapLevel> levels;
  std::vector<HardeningRow> hardening;
  coupling::CapChoice law;
  std::vector<std::string> remarks; ///< sentences that a user should know
};

/// Drucker-Prager cap tables from probes, at least one of which is uniaxial.
/// At each density of the scans: d and beta from the shear points, R from the
/// state on the uniaxial path and the direction of plastic flow there, E and nu
/// from the moduli, or from uniaxial unloading; p_b from isotropic paths, or
/// without any from the caps through the states of the uniaxial ones. Densities
/// are those of the unloaded powder. d, E and p_b do not fall with density.
/// Throws InputError saying what the data lack.
CapFit fit_cap(const std::vector<ProbeData> &probes, YieldCriterion criterion);
} // namespace tamp::apps

#endif
