// SPDX-License-Identifier: BSD-3-Clause
#include <dem/cell_shape.h>
#include <dem/random_numbers.h>
#include <dem/random_start.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace tamp::dem
{
namespace
{
/// Puts one grain where it touches none of the others.
bool add_grain(UnitCell &cell, double radius, RandomNumbers &random)
{
  constexpr int most_tries = 200000;
  for (int k = 0; k < most_tries; ++k) {
    const double x = random.next(), y = random.next(), z = random.next();
    const Vector3 place(x, y, z);
    bool free = true;
    for (std::size_t i = 0; free && i < cell.place.size(); ++i) {
      const double reach = radius + cell.radius[i];
      free = cell.box.nearest_image(place - cell.place[i]).squaredNorm() >
             reach * reach;
    }
    if (free) {
      cell.place.push_back(place);
      cell.radius.push_back(radius);
      return true;
    }
  }
  return false;
}
} // namespace

UnitCell random_start(const PackingRequest &request)
{
  std::vector<double> radius =
      draw_radii(request.sizes, request.grain_count, request.seed);
  std::ranges::sort(radius, std::greater());
  UnitCell cell;
  cell.material = request.material;
  cell.contact = request.contact;
  cell.radius = radius;
  const double ratio = cell_shape(request);
  const double edge = std::cbrt(cell.solid_volume() /
                                (request.initial_relative_density * ratio));
  cell.radius.clear();
  cell.box.h = edge * Matrix3::Identity();
  cell.box.h(2, 2) *= ratio;
  RandomNumbers random(seed_of(request.seed, 0));
  for (double r : radius)
    if (!add_grain(cell, r, random))
      throw std::runtime_error(
          "no room for more grains at an initial relative density of " +
          std::to_string(request.initial_relative_density) +
          "; choose 0.36 or less");
  cell.reference_volume = cell.box.volume();
  return cell;
}
} // namespace tamp::dem
