// SPDX-License-Identifier: BSD-3-Clause
#include <apps/check/die_trial.h>
#include <fem/build_mesh.h>
#include <fem/die_model.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace tamp::apps
{
namespace
{
constexpr double most_seconds = 1;
constexpr unsigned most_steps = 12;
// Of which a step takes a fraction of a second.
constexpr std::size_t most_unknowns_in_plane = 5000,
                      most_unknowns_in_space = 1500;
// As LinearMethod::automatic.
constexpr std::size_t most_direct_in_space = 20000;

double now()
{
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

// The geometry of a coarser cylinder as high and wide as the mesh.
fem::DieGeometry stand_in(const fem::Mesh &mesh)
{
  fem::DieGeometry geometry;
  double low = mesh.nodes.front()[2], high = low, radius = 0;
  for (const auto &node : mesh.nodes) {
    low = std::min(low, node[2]);
    high = std::max(high, node[2]);
    radius = std::max(radius, std::hypot(node[0], node[1]));
  }
  geometry.section = mesh.section;
  geometry.radius = radius;
  geometry.fill_height = high - low;
  geometry.radial_elements = mesh.is_axisymmetric() ? 30 : 4;
  geometry.axial_elements = mesh.is_axisymmetric() ? 60 : 6;
  if (mesh.section == fem::Section::full)
    geometry.radial_elements = 3;
  return geometry;
}

void run(fem::DieModel &model, DieTrial &trial)
{
  const double begin = now();
  while (trial.steps < most_steps && now() - begin < most_seconds) {
    const fem::Advance answer = model.advance();
    if (answer == fem::Advance::finished)
      break;
    if (answer == fem::Advance::failed) {
      trial.problem = model.failure().reason;
      break;
    }
    ++trial.steps;
    trial.updates += model.last_step().material_updates;
  }
  trial.seconds = now() - begin;
  trial.linear_seconds = model.times().linear_solver;
}
} // namespace

DieTrial try_die(const RunInput &input)
{
  const fem::Mesh &own = input.mesh.mesh;
  DieTrial trial;
  trial.own_mesh =
      own.number_of_dofs() <=
      (own.is_axisymmetric() ? most_unknowns_in_plane : most_unknowns_in_space);
  fem::DieSettings settings = input.die;
  fem::Mesh coarse;
  if (!trial.own_mesh) {
    settings.geometry = stand_in(own);
    coarse = fem::build_mesh(settings.geometry);
  }
  const fem::Mesh &mesh = trial.own_mesh ? own : coarse;
  trial.unknowns = mesh.number_of_dofs();
  trial.points = mesh.number_of_points();
  coupling::MaterialChoice choice = input.material;
  if (!trial.own_mesh)
    choice.densities.clear();
  auto material = coupling::make_material(choice, trial.points);
  fem::DieModel model(settings, mesh, *material.points);
  run(model, trial);
  return trial;
}

bool solves_iteratively(const RunInput &input)
{
  const fem::Mesh &mesh = input.mesh.mesh;
  switch (input.die.solver.linear.method) {
  case fem::LinearMethod::direct:
    return false;
  case fem::LinearMethod::iterative:
    return true;
  case fem::LinearMethod::automatic:
    return !mesh.is_axisymmetric() &&
           mesh.number_of_dofs() > most_direct_in_space;
  }
  return false;
}

double seconds_per_step(const DieTrial &trial, const RunInput &input)
{
  const fem::Mesh &mesh = input.mesh.mesh;
  const double steps = std::max(trial.steps, 1u);
  const double linear = trial.linear_seconds / steps;
  const double others = trial.seconds / steps - linear;
  // Nested dissection: George (1973), SIAM J. Numer. Anal. 10:345.
  const double power = solves_iteratively(input) ? 1.2
                       : mesh.is_axisymmetric()  ? 1.5
                                                 : 2;
  return others * double(mesh.number_of_points()) / double(trial.points) +
         linear *
             std::pow(double(mesh.number_of_dofs()) / double(trial.unknowns),
                      power);
}
} // namespace tamp::apps
