// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_constants_fit_h
#define apps_fit_constants_fit_h

#include <apps/fit/cap_fit.h>
#include <apps/fit/surface_plots.h>

#include <string>
#include <vector>

namespace tamp::apps
{
/// A constant of a law and how much it differs between replicas.
struct FittedConstant {
  std::string name; ///< as in the law's subsection of Material
  std::string unit; ///< "Pa" or "-"
  double value = 0;
  double deviation = 0; ///< of one replica, with N - 1; zero of a single one
};

/// A law of a few constants, and how far the probes are from it.
struct ConstantsFit {
  coupling::MaterialChoice law;
  std::vector<FittedConstant> constants;
  unsigned replicas = 0;
  /// Fitted to each replica alone; none of a single one.
  std::vector<coupling::MaterialChoice> replica_laws;
  /// Densities under load between which probes and law were compared [-].
  double first_density = 0, last_density = 0;
  /// Root mean squares, without weights: see fit_constants().
  double path_residual = 0, yield_residual = 0, modulus_residual = 0;
  std::vector<SurfacePicture> surfaces;
  std::vector<std::string> remarks;
};

/// Modified Cam-Clay (M, lambda, kappa, nu, p_c) or FKM-Gurson (sigma_0, E_s,
/// nu, b, D_0) by least squares: points of the law are driven along the paths
/// of the probes, and the mean squares of three kinds of differences are
/// summed: ln p and q / p on the paths; ln of the distance of yield points from
/// the middle of the surface, with a weight of 0.2; ln K and ln G, with 0.5. So
/// a law whose surface has another shape than that of the powder follows the
/// paths. The minimum is found by the method of Levenberg and Marquardt (Ceres
/// Solver). Throws InputError saying what the data lack, and std::runtime_error
/// if there is no minimum.
/// @param kind  modified_cam_clay or fkm_gurson.
ConstantsFit fit_constants(coupling::MaterialKind kind,
                           const std::vector<ProbeData> &probes,
                           YieldCriterion criterion);
} // namespace tamp::apps

#endif
