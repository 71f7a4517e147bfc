// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_laws_pair_law_h
#define dem_laws_pair_law_h

#include <cmath>

namespace tamp::dem
{
/// What a normal law answers for a pair at overlap delta. V is double, or a
/// pack of lanes.
template <class V>
struct NormalAnswer {
  V force;          ///< N, compression positive [N]
  V contact_radius; ///< a [m]
};

/// Elastic energy and energy lost for good in a normal contact [J].
struct NormalEnergy {
  double elastic = 0;
  double dissipated = 0;
};
} // namespace tamp::dem

#endif
