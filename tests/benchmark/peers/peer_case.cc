// SPDX-License-Identifier: BSD-3-Clause
#include <dem/deform.h>
#include <dem/measures.h>
#include <dem/servo.h>
#include <dem/unit_cell.h>
#include <tests/benchmark/peers/peer_cell.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using namespace tamp::dem;
using tamp::speed::number;
using tamp::speed::read_peer_cell;

// The path of the case; `run.sh` gives the same to the peers.
constexpr double friction_coefficient = 0.3; // [-]
constexpr double strain_rate = 6;            // [1/s]
constexpr double time_step = 1.5e-7;         // [s]
// That step as a share of the largest that tamp would make with these grains.
constexpr double time_step_fraction = 0.17; // [-]
// Part of the path that the quasi-static map takes at once.
constexpr double map_increment = 1e-3; // [-]

void write_cell(const UnitCell &cell)
{
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10)
            << "# L " << cell.box.h.diagonal().transpose() << '\n';
  for (std::size_t i = 0; i < cell.size(); ++i) {
    Vector3 s = cell.place[i];
    s -= s.array().floor().matrix();
    std::cout << (cell.box.h * s).transpose() << ' ' << cell.radius[i] << '\n';
  }
}

/// A line "state density axial lateral lateral Z", compression positive.
void report(const UnitCell &cell)
{
  const CellMeasures now = measure(cell);
  std::cout << "state " << std::setprecision(9) << now.relative_density << ' '
            << -now.stress(2, 2) << ' ' << -now.stress(0, 0) << ' '
            << -now.stress(1, 1) << ' ' << now.coordination_number << std::endl;
}

Stretch uniaxial(double log_strain)
{
  Stretch stretch = Stretch::Identity();
  stretch(2, 2) = std::exp(-log_strain);
  return stretch;
}

/// Dynamics without scaling of the density, at the peers' rate and step.
Driving dynamics()
{
  Driving driving;
  driving.method = Method::dynamics;
  driving.dynamics.strain_rate = strain_rate;
  driving.dynamics.density_scaling = 1;
  driving.dynamics.time_step_fraction = time_step_fraction;
  return driving;
}

Driving quasi_static()
{
  Driving driving;
  driving.quasi_static.maximum_strain_increment = map_increment;
  return driving;
}

/// Compresses a loose packing isotropically to a pressure and lets it settle
/// to near round-off. Without friction no force but the normal ones is behind
/// the equilibrium, and a list of places says all of it.
void jam(const std::string &file, double pressure, double friction)
{
  UnitCell cell = read_peer_cell(file, friction);
  ServoGoal goal;
  goal.pressure = pressure;
  goal.accuracy = 1e-4;
  const CellAnswer answer = servo_to_pressure(cell, goal, dynamics().dynamics);
  if (answer.outcome != Outcome::settled)
    throw std::runtime_error("the packing did not settle at the pressure");
  Driving settle;
  settle.quasi_static.unbalance_tolerance = 1e-8;
  settle.quasi_static.maximum_evaluations = 100000;
  deform(cell, Stretch::Identity(), settle);
  write_cell(cell);
}

/// From the start to each relative density in turn.
void compact(const std::string &file,
             const std::vector<std::string> &densities,
             Method method)
{
  UnitCell cell = read_peer_cell(file, friction_coefficient);
  const Driving driving =
      method == Method::dynamics ? dynamics() : quasi_static();
  deform(cell, Stretch::Identity(), driving);
  report(cell);
  std::size_t evaluations = 0;
  for (const std::string &wanted : densities) {
    const double strain = std::log(number(wanted) / cell.relative_density());
    evaluations += deform(cell, uniaxial(strain), driving).evaluations;
    report(cell);
  }
  std::cout << "evaluations " << evaluations << std::endl;
}

/// About so many time steps of the compaction; timed from outside.
void step(const std::string &file, double steps)
{
  UnitCell cell = read_peer_cell(file, friction_coefficient);
  const double strain = steps * strain_rate * time_step;
  const CellAnswer answer = deform(cell, uniaxial(strain), dynamics());
  report(cell);
  std::cout << "steps " << answer.evaluations << std::endl;
}

void run(const std::vector<std::string> &words)
{
  const std::string task = words.empty() ? "" : words[0];
  if (task == "jam" && words.size() == 4)
    jam(words[1], number(words[2]), number(words[3]));
  else if ((task == "map" || task == "dynamics") && words.size() > 2)
    compact(words[1],
            {words.begin() + 2, words.end()},
            task == "map" ? Method::quasi_static : Method::dynamics);
  else if (task == "steps" && words.size() == 3)
    step(words[1], number(words[2]));
  else
    throw std::invalid_argument(
        "usage: peer_case jam PACKING PRESSURE FRICTION | "
        "map START DENSITY... | "
        "dynamics START DENSITY... | "
        "steps START COUNT");
}
} // namespace

/// The case of the peers, by tamp.
int main(int argc, char **argv)
{
  try {
    run({argv + 1, argv + argc});
  } catch (const std::exception &error) {
    std::cerr << "peer_case: " << error.what() << std::endl;
    return 2;
  }
}
