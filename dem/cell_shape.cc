// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_shape.h>
#include <dem/packing.h>
#include <dem/random_start.h>
#include <dem/value_check.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace tamp::dem
{
namespace
{
// Where grains jam: as loose as any packing, and as most do.
constexpr double loosest_jammed = 0.55, usually_jammed = 0.6;
// Widest skin of a neighbour list, of the mean radius.
constexpr double skin = 0.3;
// Growth of single grains to full density by the law mdr, at most.
constexpr double largest_growth = 1.15;

/// What matters of the grains.
struct Solid {
  double volume; ///< of all grains [m3]
  double width;  ///< that a box must have [m]
};

Solid solid_of(const PackingRequest &request)
{
  const std::vector<LooseGrain> grains = draw_grains(request);
  double cubes = 0, sum = 0;
  for (const auto &[r, species] : grains) {
    cubes += r * r * r;
    sum += r;
  }
  const double mean = sum / double(grains.size());
  const double growth =
      request.contact.normal_law == NormalLaw::mdr ? largest_growth : 1;
  return {4 * std::numbers::pi / 3 * cubes,
          2 * growth * (2 * grains.front().radius + skin * mean)};
}

/// Density at which the box still has the shape of the loose start, as far as
/// the axial compaction that follows is concerned.
double shaped_density(const PackingRequest &request)
{
  if (request.goal.compression == Compression::uniaxial)
    return request.initial_relative_density;
  return request.goal.target == CompressionTarget::relative_density
             ? request.goal.relative_density
             : loosest_jammed;
}

double automatic_ratio(const PackingRequest &request, const Solid &solid)
{
  double cubic = 1;
  if (request.goal.compression == Compression::uniaxial)
    cubic = (request.goal.target == CompressionTarget::relative_density
                 ? request.goal.relative_density
                 : usually_jammed) /
            request.initial_relative_density;
  // Height at a density of 1: (ratio shaped)^(2/3) volume^(1/3).
  const double wide = std::pow(solid.width / std::cbrt(solid.volume), 1.5) /
                      shaped_density(request);
  return std::max(cubic, wide);
}
} // namespace

double cell_shape(const PackingRequest &request)
{
  const Solid solid = solid_of(request);
  const bool open = request.edge_ratio == 0;
  if (!open)
    Positive{}(request.edge_ratio, "edge ratio of the cell");
  const double ratio =
      open ? automatic_ratio(request, solid) : request.edge_ratio;
  const double shaped = shaped_density(request);
  const double lateral = std::cbrt(solid.volume / (shaped * ratio));
  const double least = std::min(lateral, lateral * ratio * shaped);
  // The automatic ratio meets the width to rounding.
  if (least < (1 - 1e-9) * solid.width) {
    std::ostringstream expected;
    expected << (open ? "more" : "such")
             << ": compacted along z to a relative density of 1 the cell is "
             << least << " m wide and must have " << solid.width
             << " m, two contact distances of its largest grains";
    if (open)
      refuse("grain count", double(request.grain_count), expected.str());
    refuse("edge ratio of the cell", ratio, expected.str());
  }
  return ratio;
}
} // namespace tamp::dem
