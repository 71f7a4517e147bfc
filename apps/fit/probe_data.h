// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_probe_data_h
#define apps_fit_probe_data_h

#include <filesystem>
#include <vector>

namespace tamp::apps
{
/// A state on the main path of a probe, compression positive.
struct PathPoint {
  double relative_density = 0;  ///< under load [-]
  double pressure = 0;          ///< p [Pa]
  double deviatoric_stress = 0; ///< q [Pa]
  double axial_strain = 0;      ///< logarithmic [-]
  double axial_stress = 0;      ///< [Pa]
};

/// What a branch from the main path to yield has found, compression positive.
struct YieldPoint {
  int replica = 0;
  double relative_density = 0;   ///< where the branch begins [-]
  double reached_pressure = 0;   ///< there [Pa]
  double reached_deviator = 0;   ///< there [Pa]
  int branch = 0, criterion = 0; ///< see tamp probe
  double pressure = 0;           ///< p at yield [Pa]
  double deviatoric_stress = 0;  ///< q at yield [Pa]
  double plastic_compaction = 0; ///< increment at yield [-]
  double plastic_shear = 0;      ///< increment at yield [-]
};

/// Elastic moduli of a state on the main path.
struct ModuliPoint {
  int replica = 0;
  double relative_density = 0; ///< under load [-]
  double bulk_modulus = 0;     ///< K [Pa]
  double shear_modulus = 0;    ///< G [Pa]
};

enum class Loading { isotropic, uniaxial };

/// What fits read of a folder that tamp probe has written.
struct ProbeData {
  std::filesystem::path folder;
  Loading loading = Loading::uniaxial;
  std::vector<PathPoint> curve;     ///< while density grows, up to the peak
  std::vector<PathPoint> unloading; ///< from the peak on, while stress falls
  std::vector<YieldPoint> yields;   ///< none without a yield.csv
  std::vector<ModuliPoint> moduli;  ///< none without a moduli.csv
};

/// The folders of a result of tamp probe that are to be read: those of its
/// cells of the largest size if it has several (--replicas), else itself.
std::vector<std::filesystem::path>
cells_of(const std::filesystem::path &folder);

/// Reads curve.csv, and yield.csv and moduli.csv if they are there. Throws
/// InputError naming file and line if a file is not as tamp probe writes it, or
/// if loading is neither isotropic (q below a tenth of p at its end) nor
/// uniaxial (no lateral strain).
ProbeData read_probe(const std::filesystem::path &folder);

/// The files that read_probe() reads.
std::vector<std::filesystem::path>
probe_files(const std::filesystem::path &folder);

/// K and G from an unloading without lateral strain down to a share of the peak
/// of the axial stress, or as far as it goes: K = dp / d eps_z, G = dq / (2 d
/// eps_z), isotropic elasticity in uniaxial strain. Both are zero if there is
/// no such unloading.
ModuliPoint moduli_of_unloading(const ProbeData &probe, double share = 0.5);
} // namespace tamp::apps

#endif
