// SPDX-License-Identifier: BSD-3-Clause
#include <fem/laws/cap_tables.h>

namespace tamp::fem
{
CapSurface<ByCompaction> CapTables::surface(const double compaction)
{
  const ByCompaction eps(1, 0, compaction), density = this->density(eps);
  return CapSurface<ByCompaction>({cohesion_(density),
                                   friction_angle_(density),
                                   eccentricity_(density),
                                   hardening_(eps),
                                   parameters_.transition,
                                   parameters_.dilation});
}

CapModuli<ByCompaction> CapTables::moduli(const double compaction)
{
  const ByCompaction density = this->density(ByCompaction(1, 0, compaction));
  const ByCompaction E = youngs_modulus_(density);
  const ByCompaction nu = poissons_ratio_(density);
  return {E / (3. * (1. - 2. * nu)), E / (2. * (1. + nu))};
}
} // namespace tamp::fem
