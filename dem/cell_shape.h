// SPDX-License-Identifier: BSD-3-Clause
#ifndef dem_cell_shape_h
#define dem_cell_shape_h

namespace tamp::dem
{
struct PackingRequest;

/// The edge along z over the lateral edges of the loose start of a packing [-].
/// If the request leaves it open: so that the packing is about cubic when it is
/// handed over, or as much taller as it must be to stay wide enough for nearest
/// images (four radii of the largest grain and the skin of the lists) when it
/// is compacted along z until no pore is left. Throws std::invalid_argument
/// naming grain count or edge ratio if it would become too narrow.
double cell_shape(const PackingRequest &request);
} // namespace tamp::dem

#endif
