// SPDX-License-Identifier: BSD-3-Clause
#ifndef apps_calibrate_compaction_curve_h
#define apps_calibrate_compaction_curve_h

#include <vector>

namespace tamp::apps
{
/// A place on the way of a compact, compression positive.
struct CompactionPoint {
  double relative_density = 0; ///< [-]
  double axial = 0;            ///< pressure of the punch [Pa]
  double lateral = 0;          ///< pressure on the wall, if it is known [Pa]
};

/// How a powder was compacted between a punch and walls: loaded up to its
/// largest density, the last point of `loading`, then unloaded.
struct CompactionCurve {
  std::vector<CompactionPoint> loading, unloading;
  bool has_lateral = false;

  const CompactionPoint &peak() const { return loading.back(); }
};
} // namespace tamp::apps

#endif
