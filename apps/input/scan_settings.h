// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_input_scan_settings_h
#define apps_input_scan_settings_h

#include <vector>

namespace tamp::apps
{
class ParameterTable;

/// Scans of the yield surface on the way of a probe; shares are those of the
/// reached pressure to which the powder is unloaded before [-].
struct ScanSettings {
  std::vector<double> densities; ///< relative, rising; none: no scan [-]
  std::vector<double> compression_shares, extension_shares, triaxial_shares,
      isotropic_shares, uniaxial_shares;
  double strain_offset = 5e-4;  ///< irreversible strain at yield [-]
  double plastic_work = 5e-4;   ///< at yield, over the reached pressure [-]
  double modulus_strain = 1e-4; ///< of the small probes [-]
  double increment = 2e-4;      ///< of strain until yield [-]
  double largest_strain = 0.2;  ///< of a branch [-]

  bool on() const { return !densities.empty(); }
};

/// Section `Scan`.
void declare_scan(ParameterTable &table);
/// Throws InputError where values do not fit together.
ScanSettings read_scan(const ParameterTable &table);
} // namespace tamp::apps

#endif
