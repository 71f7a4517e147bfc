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

std::vector<LooseGrain> draw_grains(const PackingRequest &request)
{
  std::vector<LooseGrain> grains;
  const auto add =
      [&](const GrainSizes &sizes, std::size_t count, std::size_t species) {
        for (double r : draw_radii(sizes, count, request.seed))
          grains.push_back({r, static_cast<std::uint8_t>(species)});
      };
  std::size_t left = request.grain_count;
  for (std::size_t k = 0; k < request.others.size(); ++k) {
    const GrainPopulation &other = request.others[k];
    const auto wanted = static_cast<std::size_t>(
        std::lround(other.number_share * double(request.grain_count)));
    const std::size_t count = std::min(left, wanted);
    add(other.sizes, count, k + 1);
    left -= count;
  }
  add(request.sizes, left, 0);
  std::ranges::stable_sort(grains, std::greater(), &LooseGrain::radius);
  return grains;
}

UnitCell random_start(const PackingRequest &request)
{
  const std::vector<LooseGrain> grains = draw_grains(request);
  UnitCell cell;
  cell.materials = {request.material};
  for (const GrainPopulation &other : request.others)
    cell.materials.push_back(other.material);
  cell.contact = request.contact;
  for (const LooseGrain &grain : grains) {
    cell.radius.push_back(grain.radius);
    if (!request.others.empty())
      cell.species.push_back(grain.species);
  }
  const double ratio = cell_shape(request);
  const double edge = std::cbrt(cell.solid_volume() /
                                (request.initial_relative_density * ratio));
  cell.radius.clear();
  cell.box.h = edge * Matrix3::Identity();
  cell.box.h(2, 2) *= ratio;
  RandomNumbers random(seed_of(request.seed, 0));
  for (const LooseGrain &grain : grains)
    if (!add_grain(cell, grain.radius, random))
      throw std::runtime_error(
          "no room for more grains at an initial relative density of " +
          std::to_string(request.initial_relative_density) +
          "; choose 0.36 or less");
  cell.reference_volume = cell.box.volume();
  return cell;
}
} // namespace tamp::dem
