// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_size_table_h
#define dem_size_table_h

#include <dem/grain_sizes.h>

#include <vector>

namespace tamp::dem
{
/// The quantiles of a measured size distribution, by number. Of a table by
/// volume, f_n ~ f_v / d^3 with f_v constant between two lines: a section with
/// the share v of the volume holds the share of the number
/// ~ v (d_0 + d_1) / (2 d_0^2 d_1^2).
class SizeTable
{
public:
  /// Throws std::invalid_argument naming the first line that is not possible.
  SizeTable(const std::vector<SizeShare> &lines, ShareBasis basis);

  /// The diameter [m] below which `share` of the grains lie, 0 to 1.
  double quantile(double share) const;

private:
  struct Section {
    double first, last; ///< diameters [m]
    double below;       ///< share by number of all sections before
    double share;       ///< by number
  };
  std::vector<Section> sections_;
  ShareBasis basis_;
};
} // namespace tamp::dem

#endif
