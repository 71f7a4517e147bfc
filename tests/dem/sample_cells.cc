// SPDX-License-Identifier: BSD-3-Clause
#include <dem/random_numbers.h>
#include <dem/sweep_layout.h>
#include <tests/dem/sample_cells.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace tamp::dem::test
{
namespace
{
/// Gives the cell the contacts of its places.
void touch(UnitCell &cell)
{
  SweepLayout<double> layout(cell, best_instruction_set());
  layout.list_pairs(cell, cell.box, cell.place);
  layout.sweep({}, {Memory::written});
  layout.read_memories(cell);
}
} // namespace

PackingRequest alumina_request()
{
  PackingRequest request;
  request.grain_count = 200;
  request.sizes.minimum_diameter = 450e-6;
  request.sizes.maximum_diameter = 650e-6;
  request.material = {3.5e9, 0.3, 2000, 50e6};
  request.contact.friction_coefficient = 0.35;
  request.goal.pressure = 0.5e6;
  return request;
}

const UnitCell &alumina_cell()
{
  static const UnitCell cell = make_packing(alumina_request());
  return cell;
}

const UnitCell &smooth_elastic_cell()
{
  static const UnitCell cell = [] {
    PackingRequest request = alumina_request();
    request.contact = {.normal_law = NormalLaw::hertz,
                       .tangential_law = TangentialLaw::none,
                       .friction_coefficient = 0};
    return make_packing(request);
  }();
  return cell;
}

PackingRequest table_one_request(std::uint64_t seed)
{
  PackingRequest request;
  request.seed = seed;
  return request;
}

UnitCell random_cell(std::size_t count, std::uint64_t seed)
{
  RandomNumbers random(seed);
  UnitCell cell;
  const double edge = 1e-4 * 1.9 * std::cbrt(double(count));
  cell.box.h = edge * Matrix3::Identity();
  for (int k = 0; k < 9; ++k)
    cell.box.h(k % 3, k / 3) += 0.15 * edge * (2 * random.next() - 1);
  cell.reference_volume = cell.box.volume();
  for (std::size_t i = 0; i < count; ++i) {
    cell.radius.push_back(1e-4 * (0.8 + 0.4 * random.next()));
    const double x = random.next(), y = random.next(), z = random.next();
    cell.place.emplace_back(3 * x - 1, 3 * y - 1, 3 * z - 1);
  }
  touch(cell);
  for (ContactMemory &memory : cell.contacts) {
    const auto [i, j] = memory.pair;
    const Vector3 branch =
        cell.box.nearest_image(cell.place[j] - cell.place[i]);
    const Vector3 any(random.next() - .5, random.next() - .5, random.next());
    memory.tangential_force = 0.02 * any.cross(branch.normalized());
    memory.largest_overlap *= 1 + 0.1 * random.next();
    memory.contact_radius *= 0.9 + 0.2 * random.next();
  }
  return cell;
}

UnitCell fcc_cell(double overlap, const ContactModel &contact)
{
  constexpr int cubes = 3;
  UnitCell cell;
  cell.contact = contact;
  const double radius = 1e-4, distance = 2 * radius / (1 + overlap);
  cell.box.h = cubes * std::sqrt(2.0) * distance * Matrix3::Identity();
  cell.reference_volume = cell.box.volume();
  for (int k = 0; k < cubes * cubes * cubes; ++k) {
    const Vector3 corner(k % cubes, k / cubes % cubes, k / cubes / cubes);
    for (const Vector3 &site : {Vector3(0, 0, 0),
                                Vector3(.5, .5, 0),
                                Vector3(.5, 0, .5),
                                Vector3(0, .5, .5)})
      cell.place.push_back((corner + site) / cubes);
  }
  cell.radius.assign(cell.place.size(), radius);
  touch(cell);
  return cell;
}

std::vector<ContactModel> every_contact_model()
{
  std::vector<ContactModel> models;
  for (NormalLaw normal : {NormalLaw::hertz,
                           NormalLaw::thornton_ning,
                           NormalLaw::jkr,
                           NormalLaw::thornton_ning_jkr,
                           NormalLaw::storakers,
                           NormalLaw::thornton_ning_adjusted})
    for (TangentialLaw tangential : {TangentialLaw::none,
                                     TangentialLaw::mindlin,
                                     TangentialLaw::mindlin_deresiewicz})
      for (RollingLaw rolling : {RollingLaw::none, RollingLaw::epsd})
        models.push_back({.normal_law = normal,
                          .tangential_law = tangential,
                          .rolling_law = rolling,
                          .work_of_adhesion = 5,
                          .restitution_coefficient = 0.7});
  return models;
}

void mix_species(UnitCell &cell)
{
  cell.materials = {{70e9, 0.3, 2650, 0.5e9}, {210e9, 0.28, 7800, 1.2e9}};
  cell.species.resize(cell.size());
  for (std::size_t i = 0; i < cell.size(); ++i)
    cell.species[i] = i % 2;
}

Stretch uniaxial(double log_strain)
{
  Stretch stretch = Stretch::Identity();
  stretch(1, 1) = std::exp(log_strain);
  return stretch;
}

CellAnswer
compress(UnitCell &cell, double log_strain, int parts, const Driving &driving)
{
  CellAnswer answer;
  Outcome worst = Outcome::settled;
  std::size_t evaluations = 0;
  for (int k = 0; k < parts; ++k) {
    answer = deform(cell, uniaxial(log_strain / parts), driving);
    worst = std::max(worst, answer.outcome);
    evaluations += answer.evaluations;
  }
  answer.outcome = worst;
  answer.evaluations = evaluations;
  return answer;
}
} // namespace tamp::dem::test
