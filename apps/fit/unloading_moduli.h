// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_fit_unloading_moduli_h
#define apps_fit_unloading_moduli_h

#include <apps/fit/probe_data.h>

#include <vector>

namespace tamp::apps
{
/// Where fits take elastic moduli from.
enum class ModuliSource {
  probes,   ///< small probes; without any, half an unloading
  unloading ///< the whole unloading of the uniaxial path
};

/// Has all moduli be secants of the whole unloading of the uniaxial path: each
/// row is multiplied by what these secants are of the moduli of small probes at
/// the end of the path. A folder without unloading takes the mean of the
/// others, one without rows its secants. Throws InputError if no uniaxial probe
/// is unloaded, or if an unloading gives no moduli above zero.
void take_unloading_moduli(std::vector<ProbeData> &probes);
} // namespace tamp::apps

#endif
