// SPDX-License-Identifier: BSD-3-Clause
#include <apps/selftest/self_checks.h>
#include <fem/build_mesh.h>
#include <fem/die_model.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/elastic.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
using namespace fem;
using Checks = std::vector<SelfCheck>;
constexpr double pi = std::numbers::pi;
constexpr double modulus = 1e9, nu = .3; // E [Pa]

/// A smooth die of an elastic powder, balanced to 1e-9.
DieSettings die(unsigned radial, unsigned axial)
{
  DieSettings settings;
  settings.geometry.radial_elements = radial;
  settings.geometry.axial_elements = axial;
  settings.friction.fill(FrictionCoefficient(0));
  settings.solver.method = NonlinearMethod::newton;
  settings.solver.force_tolerance = 1e-9;
  settings.solver.displacement_tolerance = 1e-8;
  return settings;
}

Elastic powder(double poissons_ratio = nu, double radial_stress = 0)
{
  ElasticParameters parameters;
  parameters.elasticity = {modulus, poissons_ratio};
  parameters.initial_stress[0][0] = parameters.initial_stress[1][1] =
      radial_stress;
  return Elastic(parameters);
}

/// A die that has gone through its stages.
struct Pressed {
  Mesh mesh;
  ContinuumPoints<Elastic> points;
  DieModel model;
  std::vector<StepRecord> steps;

  Pressed(const DieSettings &settings, const Elastic &law)
      : mesh(build_mesh(settings.geometry)),
        points(law, mesh.number_of_points()), model(settings, mesh, points)
  {
    Advance advance = Advance::stepped;
    while ((advance = model.advance()) == Advance::stepped)
      steps.push_back(model.last_step());
    if (advance != Advance::finished)
      throw std::runtime_error(model.failure().reason);
  }
  const StepRecord &last() const { return model.last_step(); }
};

Stage press_by(double length)
{
  return {StageKind::press, StageTarget::displacement, length};
}

/// All points of a smooth die feel the same.
void patch(Checks &checks)
{
  constexpr double balanced = 1e-7; // forces to 1e-9
  DieSettings settings = die(3, 4);
  const double height = settings.geometry.fill_height,
               radius = settings.geometry.radius;
  settings.stages = {press_by(.05 * height)};
  const Pressed run(settings, powder());
  const double stress = modulus * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) *
                        -std::log(run.last().compact_height / height);
  checks.push_back({"smooth die, 3 x 4 elements: force / closed form",
                    run.last().upper_force / (pi * radius * radius * stress),
                    1,
                    balanced,
                    "Hooke, logarithmic strain"});
  checks.push_back({"  force of the wall / closed form",
                    run.last().wall_normal_force /
                        (2 * pi * radius * run.last().compact_height * stress *
                         nu / (1 - nu)),
                    1,
                    balanced,
                    "Hooke, logarithmic strain"});
  const auto &first = run.model.responses().front().stress;
  double uneven = 0;
  for (const Response &response : run.model.responses())
    uneven = std::max(uneven, (response.stress - first).norm() / first.norm());
  checks.push_back(
      {"  unevenness of the stress", uneven, 0, balanced, "patch test"});
  checks.push_back({"  work of the tools less that of the powder",
                    run.last().work.residual(),
                    0,
                    balanced,
                    "conservation"});
}

/// A column as high as wide whose wall slips everywhere.
void transmission(Checks &checks)
{
  // The slab takes the stress as uniform across the column.
  constexpr double slab = .02, mu_k = .1;
  DieSettings settings = die(16, 32);
  settings.geometry.fill_height = 2 * settings.geometry.radius;
  settings.friction[die_wall] = FrictionCoefficient(mu_k * (1 - nu) / nu);
  settings.stages = {press_by(1e-3 * settings.geometry.fill_height)};
  const Pressed run(settings, powder());
  checks.push_back({"transmission of a column as high as wide, mu k = 0.1",
                    run.last().lower_force / run.last().upper_force,
                    .670,
                    slab,
                    "Janssen (1895), Walker (1966)"});
}

/// A compact under radial stress that fills the die, pushed out.
void ejection(Checks &checks)
{
  constexpr double stress = 1e4, mu = .1;
  constexpr double small = 1e-4; // strains are 1e-5
  DieSettings settings = die(1, 1);
  const double height = settings.geometry.fill_height,
               radius = settings.geometry.radius;
  settings.friction[die_wall] = FrictionCoefficient(mu);
  settings.solver.force_tolerance = 1e-2; // displacements settle better
  settings.solver.displacement_tolerance = 1e-9;
  settings.stages = {
      press_by(1e-9 * height),
      {.kind = StageKind::eject, .target = StageTarget::out, .hold_share = 0}};
  // Without Poisson's ratio the axial stress leaves that on the wall alone.
  const Pressed straight(settings, powder(0, -stress));
  double force = 0;
  for (const StepRecord &step : straight.steps)
    force = std::max(force, step.lower_force);
  checks.push_back({"ejection: largest force / (mu s 2 pi R H)",
                    force / (mu * stress * 2 * pi * radius * height),
                    1,
                    small,
                    "Coulomb"});
  const StepRecord free = Pressed(settings, powder(nu, -stress)).last();
  checks.push_back(
      {"  radial spring-back / (s (1 - nu) / E)",
       std::log(free.compact_radius / radius) * modulus / (stress * (1 - nu)),
       1,
       small,
       "Hooke"});
  checks.push_back(
      {"  axial spring-back / (-2 nu s / E)",
       std::log(free.compact_height / height) * modulus / (-2 * nu * stress),
       1,
       small,
       "Hooke"});
}
} // namespace

std::vector<SelfCheck> check_dies()
{
  Checks checks;
  patch(checks);
  transmission(checks);
  ejection(checks);
  return checks;
}
} // namespace tamp::apps
