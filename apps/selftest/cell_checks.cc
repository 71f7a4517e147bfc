// SPDX-License-Identifier: BSD-3-Clause
#include <apps/selftest/self_checks.h>
#include <coupling/unit_cell_points.h>
#include <dem/cell_laws.h>
#include <dem/dynamics.h>
#include <dem/measures.h>
#include <dem/packing.h>
#include <dem/tangent.h>
#include <dem/unit_cell_bytes.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tamp::apps
{
namespace
{
using namespace dem;
using Checks = std::vector<SelfCheck>;

/// Elastic grains that do not slide at the places of a face-centred cubic
/// lattice, 3 x 3 x 3 cubes.
/// @param distance  of centres, over 2 R
UnitCell lattice(double distance)
{
  constexpr int cubes = 3;
  constexpr double radius = 1e-4;
  UnitCell cell;
  cell.contact = {.normal_law = NormalLaw::hertz, .friction_coefficient = 10};
  cell.box.h =
      cubes * std::numbers::sqrt2 * 2 * radius * distance * Matrix3::Identity();
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
  deform(cell, Stretch::Identity(), {});
  return cell;
}

void lattice_stiffness(Checks &checks)
{
  constexpr double rounding = 1e-10, distance = .999;
  constexpr double sqrt2 = std::numbers::sqrt2;
  const std::string source = "sum over its 12 contacts";
  const UnitCell cell = lattice(distance);
  const double span = 2 * cell.radius[0] * distance;
  const auto [E, G, none] = pair_material(cell.materials[0], cell.materials[0]);
  const auto contact = contact_forces(cell).at(0);
  const double radius = std::sqrt(cell.radius[0] / 2 * contact.overlap);
  const double kn =
      Hertz{E}.loading_slope(contact.overlap, cell.shape(contact.pair), {});
  const double kt = Mindlin{G, 0}.stiffness(radius);
  const Tangent found = voigt_stiffness(cell);
  checks.push_back({"cubic lattice: 2 R C_11 / (k_n + k_t)",
                    found(0, 0) * span / (kn + kt),
                    sqrt2,
                    rounding,
                    source});
  checks.push_back({"  2 R C_12 / (k_n - k_t)",
                    found(0, 1) * span / (kn - kt),
                    1 / sqrt2,
                    rounding,
                    source});
  checks.push_back({"  2 R C_44 / (k_n + k_t)",
                    found(3, 3) / 2 * span / (kn + kt),
                    1 / sqrt2,
                    rounding,
                    source});
  const CellMeasures packing = measure(cell);
  checks.push_back(
      {"  4 R^2 p / N",
       -packing.stress.trace() / 3 * span * span / contact.normal_force,
       2 * sqrt2,
       rounding,
       source});
  checks.push_back({"  coordination number",
                    packing.coordination_number,
                    12,
                    0,
                    "geometry"});
}

/// Sixty granules at 0.5 MPa.
UnitCell granules()
{
  PackingRequest request;
  request.grain_count = 60;
  request.sizes.minimum_diameter = 450e-6;
  request.sizes.maximum_diameter = 650e-6;
  request.material = {3.5e9, .3, 2000, 50e6};
  request.goal.pressure = .5e6;
  return make_packing(request);
}

Stretch pressed(double strain)
{
  Stretch stretch = Stretch::Identity();
  stretch(2, 2) = std::exp(-strain);
  return stretch;
}

/// Smooth hard grains carry load once they are isostatic.
void jamming(Checks &checks)
{
  constexpr double sample = .03; // one of 200 grains; small ones jam looser
  PackingRequest request;
  request.grain_count = 200;
  request.contact = {.normal_law = NormalLaw::hertz,
                     .tangential_law = TangentialLaw::none,
                     .friction_coefficient = 0};
  request.goal.pressure = 1e4;
  const CellMeasures packing = measure(make_packing(request));
  const std::string source = "O'Hern et al. (2003)";
  checks.push_back({"smooth grains at 10 kPa: contacts that carry, a grain",
                    packing.mechanical_coordination_number,
                    6,
                    sample,
                    source});
  checks.push_back(
      {"  relative density", packing.relative_density, .645, sample, source});
}

void static_balance(Checks &checks, UnitCell cell)
{
  // Balanced much better than a thousandth of the forces.
  constexpr double balanced = 1e-5;
  Driving driving;
  driving.quasi_static.unbalance_tolerance = 1e-6;
  driving.quasi_static.maximum_evaluations = 20000;
  CellAnswer answer;
  for (int step = 0; step < 4; ++step)
    answer = deform(cell, pressed(5e-3), driving);
  checks.push_back({"pressing by 2 %: work of stress less that of grains",
                    answer.hill_mandel,
                    0,
                    balanced,
                    "Hill (1963)"});
  checks.push_back({"  share of the stress that is not symmetric",
                    measure(cell).asymmetry,
                    0,
                    balanced,
                    "balance of moments"});
  checks.push_back({"  solid volume / (relative density x volume)",
                    cell.solid_volume() /
                        (measure(cell).relative_density * cell.box.volume()),
                    1,
                    1e-12, // rounding
                    "grains do not change"});
}

/// What a cell holds and has lost, less the work done on it [J].
double open_energy(const UnitCell &cell, const Driving &driving)
{
  const EnergyAccount &spent = cell.energy;
  return survey_contacts(cell).elastic_energy +
         measure_dynamics(cell, driving.dynamics, 1).kinetic_energy +
         spent.plastic_dissipation + spent.friction_dissipation +
         spent.damping_dissipation + spent.adhesion_dissipation - spent.work;
}

void energy_ledger(Checks &checks, UnitCell cell)
{
  constexpr double of_the_work = .01; // what time steps leave
  Driving driving;
  driving.method = Method::dynamics;
  driving.dynamics.strain_rate = 1e-3;
  const double start = open_energy(cell, driving);
  const double before = cell.energy.work;
  double open = 0;
  for (const double strain : {.01, .01, -.01, .01}) {
    deform(cell, pressed(strain), driving);
    open = std::max(open, std::abs(open_energy(cell, driving) - start));
  }
  checks.push_back({"energy of a cell in motion: open / work",
                    open / (cell.energy.work - before),
                    0,
                    of_the_work,
                    "conservation"});
}

double differing_bytes(const UnitCell &one, const UnitCell &other)
{
  std::vector<char> a, b;
  to_bytes(one, a);
  to_bytes(other, b);
  double count = std::abs(double(a.size()) - double(b.size()));
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    count += a[i] != b[i];
  return count;
}

void same_again(Checks &checks, const UnitCell &start)
{
  UnitCell one = start, other = start;
  for (UnitCell *cell : {&one, &other})
    for (int step = 0; step < 3; ++step)
      deform(*cell, pressed(5e-3), {});
  checks.push_back({"the same path again: bytes that differ",
                    differing_bytes(one, other),
                    0,
                    0,
                    "determinism"});
}

using fem::Deformation;
using fem::Response;
constexpr std::size_t point_count = 3;

coupling::UnitCellPoints points_of(const UnitCell &cell, unsigned threads)
{
  coupling::CellPointsOptions options;
  options.threads = threads;
  return {std::vector<UnitCell>(point_count, cell), options};
}

std::vector<Response> answers(coupling::UnitCellPoints &points,
                              const dealii::Tensor<2, 3> &relative_F)
{
  std::vector<Deformation> told(point_count, Deformation{relative_F});
  for (std::size_t i = 0; i < point_count; ++i)
    told[i].relative_F[2][2] *= 1 - 1e-3 * double(i); // three cells
  std::vector<Response> responses(point_count);
  points.evaluate(told, fem::Want::stress, responses);
  points.commit();
  return responses;
}

dealii::Tensor<2, 3> uniaxial(double strain)
{
  dealii::Tensor<2, 3> F;
  F[0][0] = F[1][1] = 1;
  F[2][2] = std::exp(-strain);
  return F;
}

/// Stress after a whole turn in twelve parts, less that before, over it.
double turned_stress(const UnitCell &cell)
{
  auto points = points_of(cell, 1);
  const auto before = answers(points, uniaxial(5e-3)).front();
  dealii::Tensor<2, 3> turn;
  turn[0][0] = 1;
  turn[1][1] = turn[2][2] = std::cos(std::numbers::pi / 6);
  turn[2][1] = -(turn[1][2] = -std::sin(std::numbers::pi / 6));
  std::vector<Response> now(point_count);
  for (int part = 0; part < 12; ++part) {
    points.evaluate(std::vector<Deformation>(point_count, Deformation{turn}),
                    fem::Want::stress,
                    now);
    points.commit();
  }
  return (now.front().stress - before.stress).norm() / before.stress.norm();
}
} // namespace

std::vector<SelfCheck> check_cells()
{
  Checks checks;
  lattice_stiffness(checks);
  jamming(checks);
  const UnitCell cell = granules();
  static_balance(checks, cell);
  energy_ledger(checks, cell);
  same_again(checks, cell);
  return checks;
}

std::vector<SelfCheck> check_points()
{
  constexpr double unbalance = 1e-3; // to which cells settle
  const UnitCell cell = granules();
  auto one = points_of(cell, 1), two = points_of(cell, 2);
  double apart = 0;
  for (int step = 0; step < 3; ++step) {
    const auto a = answers(one, uniaxial(5e-3));
    const auto b = answers(two, uniaxial(5e-3));
    for (std::size_t i = 0; i < point_count; ++i)
      apart += (a[i].stress - b[i].stress).norm();
  }
  std::vector<char> bytes;
  one.pack(0, bytes);
  two.unpack(1, bytes);
  const double left = differing_bytes(one.cell(0), two.cell(1));
  return {{"a whole turn: change of the stress",
           turned_stress(cell),
           0,
           unbalance,
           "objectivity"},
          {"one thread and two: difference of stresses [Pa]",
           apart,
           0,
           0,
           "determinism"},
          {"stored and restored: bytes that differ", left, 0, 0, "identity"}};
}
} // namespace tamp::apps
