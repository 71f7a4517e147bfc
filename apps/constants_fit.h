// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_constants_fit_h
#define apps_constants_fit_h

#include <apps/cap_fit.h>
#include <apps/surface_plots.h>

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
  /// Densities under load between which probes and law were compared [-].
  double first_density = 0, last_density = 0;
  /// Root mean squares, relative: p and q on the main paths, distance of
  /// yield points from the surface, K and G.
  double path_residual = 0, yield_residual = 0, modulus_residual = 0;
  std::vector<SurfacePicture> surfaces;
  std::vector<std::string> remarks;
};

/// Modified Cam-Clay (M, lambda, kappa, nu, p_c) or FKM-Gurson (sigma_0, E_s,
/// nu, b, D_0) by least squares: points of the law are driven along the paths
/// of the probes, and what they differ by in p, in q at yield, and in K and G
/// counts alike, each relative and as a mean square. The minimum is found by
/// the method of Levenberg and Marquardt (Ceres Solver). Throws InputError
/// saying what the data lack, and std::runtime_error if there is no minimum.
/// @param kind  modified_cam_clay or fkm_gurson.
ConstantsFit fit_constants(coupling::MaterialKind kind,
                           const std::vector<ProbeData> &probes,
                           YieldCriterion criterion);
} // namespace tamp::apps

#endif
