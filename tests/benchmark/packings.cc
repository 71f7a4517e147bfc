// SPDX-License-Identifier: BSD-3-Clause
#include <tests/benchmark/packings.h>

#include <cmath>

namespace tamp::speed
{
dem::PackingRequest granules(std::size_t count)
{
  dem::PackingRequest request;
  request.grain_count = count;
  request.sizes.minimum_diameter = 450e-6;
  request.sizes.maximum_diameter = 650e-6;
  request.material = {3.5e9, 0.3, 2000, 50e6};
  request.contact.friction_coefficient = 0.35;
  request.goal.pressure = 0.5e6;
  return request;
}

dem::Stretch uniaxial(double log_strain)
{
  dem::Stretch stretch = dem::Stretch::Identity();
  stretch(1, 1) = std::exp(log_strain);
  return stretch;
}

const dem::UnitCell &Packings::compacted(std::size_t count)
{
  const auto found = made_.find(count);
  if (found != made_.end())
    return found->second;
  dem::UnitCell cell = dem::make_packing(granules(count));
  for (int k = 0; k < 25; ++k)
    dem::deform(cell, uniaxial(-2e-3), {});
  return made_.emplace(count, std::move(cell)).first->second;
}

dem::UnitCell Packings::repeated(std::size_t count)
{
  constexpr std::size_t most = 1000;
  if (count <= most)
    return compacted(count);
  const dem::UnitCell &cell = compacted(most);
  const std::size_t times = count / most;
  dem::UnitCell result = cell;
  result.neighbours = {};
  result.last = {};
  result.box.h.col(1) *= double(times);
  result.radius.clear();
  result.place.clear();
  result.contacts.clear();
  for (std::size_t copy = 0; copy < times; ++copy)
    for (std::size_t i = 0; i < cell.size(); ++i) {
      dem::Vector3 place = cell.place[i];
      place[1] =
          (place[1] - std::floor(place[1]) + double(copy)) / double(times);
      result.place.push_back(place);
      result.radius.push_back(cell.radius[i]);
    }
  return result;
}
} // namespace tamp::speed
