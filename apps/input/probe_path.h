// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_probe_path_h
#define apps_input_probe_path_h

#include <fem/path_driver.h>

#include <deal.II/base/tensor.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tamp::apps
{
/// A stage of a probe's path. If `peak_share` is set, the stage ends when the
/// axial stress has fallen to this share of the largest one so far. If
/// `density` is set, aim_at_density() must be called where the stage begins.
struct ProbeStage {
  fem::PathStage stage;
  double peak_share = 0;      ///< [-]; 0: not used
  double density = 0;         ///< relative, at the end [-]; 0: not used
  std::filesystem::path file; ///< with the gradients of the stage; or empty
};

/// What a probe does.
struct ProbePath {
  std::vector<ProbeStage> stages;
  /// If there are any, the point takes these instead of its only stage, to the
  /// last bit: F of each increment since the one before.
  std::vector<dealii::Tensor<2, 3>> increments;
};

/// Largest strains of an increment [-].
struct ProbeIncrements {
  double loading = 5e-3;
  double unloading = 1e-3;
};

/// Reads stages divided by semicolons, compression positive, axis z:
///   isotropic to strain E | to pressure P | to density D
///   uniaxial to strain E | to stress S | to density D
///   unload to strain E | to stress S | to R % of peak
///   triaxial to strain E | by strain E at pressure P
///   proportional K to strain E      (lateral strain = K x axial strain)
///   shear to strain E               (pure: strain_xz, all others at rest)
///   simple shear to strain G        (F_xz = -G since the start of the stage)
///   constant-p shear to strain E | by strain E at pressure P
///                                   (strain_xz; stress_xx, yy and zz are P)
///   constant-p compression to strain E | by strain E at pressure P
///                                   (strain_zz; stress_xx is stress_yy)
///   components xx strain E yy stress S ...   (those not named rest)
///   hold N steps
///   csv FILE                        (F of every increment since the start of
///   the
///                                   stage)
/// Throws InputError naming the stage and the word.
ProbePath parse_path(const std::string &stages,
                     const ProbeIncrements &increments);

/// Sets the strains of a stage that ends at a density, from the density where
/// it begins. Throws InputError if that is not smaller.
void aim_at_density(const ProbeStage &probe,
                    double density_now,
                    fem::PathStage &stage);

/// Reads the files of all stages; their names count from `folder`. Throws
/// InputError naming file and line.
void read_files(ProbePath &path, const std::filesystem::path &folder);

/// A path of deformation gradients.
struct GradientPath {
  std::vector<dealii::Tensor<2, 3>> gradients;
  bool relative = false; ///< each since the one before, not since the start
};

/// Reads a CSV file with columns F_xx[-], F_xy[-] ... F_zz[-], or
/// relative_F_xx[-] ... such as a die writes of its points, among others such
/// as a time, with or without the unit; without a header nine numbers a line.
/// Lines that start with # are skipped. Throws InputError naming file and line.
GradientPath read_gradients(const std::filesystem::path &file);
} // namespace tamp::apps

#endif
