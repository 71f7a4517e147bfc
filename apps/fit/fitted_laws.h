// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_fitted_laws_h
#define apps_fit_fitted_laws_h

#include <apps/fit/probe_data.h>
#include <coupling/material_factory.h>
#include <fem/laws/fkm_gurson.h>
#include <fem/laws/modified_cam_clay.h>

#include <array>
#include <string>
#include <vector>

namespace tamp::apps
{
/// A number that is sought, with its bounds.
struct Unknown {
  double start = 0, lowest = 0, highest = 0;
};

/// What the first guess of constants is made from: a state early on the main
/// path and a late one, and the moduli nearest to them.
struct FirstGuess {
  double initial_density = 0; ///< of the powder without load [-]
  PathPoint early, late;
  ModuliPoint soft, stiff;
};

/// What a name and a value of a law's subsection are.
struct NamedConstant {
  std::string name, unit;
  double value = 0;
};

/// Modified Cam-Clay as a function of M, ln(lambda - kappa), ln kappa, nu and
/// ln p_c at the initial density.
struct CamClayUnknowns {
  using Law = fem::ModifiedCamClay;
  static constexpr std::size_t count = 5;

  static std::array<Unknown, count> unknowns(const FirstGuess &guess);
  static Law law(const FirstGuess &guess, const double *unknowns);
  static std::vector<NamedConstant> constants(const Law &law);
  static ModuliPoint moduli(const Law &law, const Law::State &state);
  static double shear_limit(const Law &law, const Law::State &state, double p);
  static double yield_pressure(const Law &law, const Law::State &state);
  static coupling::MaterialChoice material(const Law &law);
};

/// FKM-Gurson as a function of ln sigma_0, ln E_s, nu, b and D_0.
struct FkmGursonUnknowns {
  using Law = fem::FkmGurson;
  static constexpr std::size_t count = 5;

  static std::array<Unknown, count> unknowns(const FirstGuess &guess);
  static Law law(const FirstGuess &guess, const double *unknowns);
  static std::vector<NamedConstant> constants(const Law &law);
  static ModuliPoint moduli(const Law &law, const Law::State &state);
  static double shear_limit(const Law &law, const Law::State &state, double p);
  static double yield_pressure(const Law &law, const Law::State &state);
  static coupling::MaterialChoice material(const Law &law);
};
} // namespace tamp::apps

#endif
