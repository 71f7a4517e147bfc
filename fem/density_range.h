// SPDX-License-Identifier: BSD-3-Clause
#ifndef fem_density_range_h
#define fem_density_range_h

#include <vector>

namespace tamp::fem
{
class Compact;

/// Relative densities of a compact's points [-].
struct DensityRange {
  double mean = 0; ///< over the volume
  double minimum = 0, maximum = 0;
};

/// Those of the accepted state. Collective.
DensityRange density_range(const Compact &compact);

/// Of every point, in the accepted state, on every rank [-]. Collective.
std::vector<double> relative_densities(const Compact &compact);
} // namespace tamp::fem

#endif
