// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_probe_path_h
#define apps_probe_path_h

#include <fem/path_driver.h>

#include <deal.II/base/tensor.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tamp::apps
{
/// A stage of a probe's path. If `peak_share` is set, the stage ends when the
/// axial stress has fallen to this share of the largest one so far.
struct ProbeStage {
  fem::PathStage stage;
  double peak_share = 0; ///< [-]; 0: not used
};

/// What a probe does: stages, or deformation gradients read from a file.
struct ProbePath {
  std::vector<ProbeStage> stages;
  std::filesystem::path gradients;
};

/// Largest strains of an increment [-].
struct ProbeIncrements {
  double loading = 5e-3;
  double unloading = 1e-3;
};

/// Reads stages divided by semicolons, compression positive, axis z:
///   isotropic to strain E | to pressure P
///   uniaxial to strain E | to stress S
///   unload to strain E | to stress S | to R % of peak
///   triaxial to strain E at pressure P
///   proportional K to strain E      (lateral strain = K x axial strain)
///   shear to strain E               (strain_xz, all others at rest)
///   components xx strain E yy stress S ...   (those not named rest)
///   hold N steps
///   csv FILE                        (F of every increment, alone)
/// Throws InputError naming the stage and the word.
ProbePath parse_path(const std::string &stages,
                     const ProbeIncrements &increments);

/// A path of deformation gradients.
struct GradientPath {
  std::vector<dealii::Tensor<2, 3>> gradients;
  bool relative = false; ///< each since the one before, not since the start
};

/// Reads a CSV file with columns F_xx[-], F_xy[-] ... F_zz[-], or
/// relative_F_xx[-] ... such as a die writes of its points, among others;
/// without a header nine numbers a line. Lines that start with # are skipped.
/// Throws InputError naming file and line.
GradientPath read_gradients(const std::filesystem::path &file);
} // namespace tamp::apps

#endif
