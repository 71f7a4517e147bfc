// SPDX-License-Identifier: BSD-3-Clause
#include <apps/check/material_trial.h>
#include <coupling/unit_cell_points.h>
#include <dem/time_step.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace tamp::apps
{
namespace
{
constexpr std::size_t most_grains = 200;
constexpr double most_seconds = 1;
constexpr double solid = 0.98;
constexpr double most_sweeps_per_step = 2000; // of dynamics
constexpr double most_strain = 3;

double now()
{
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

double smallest_rayleigh_step(const dem::UnitCell &cell, double scaling)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cell.size(); ++i)
    smallest =
        std::min(smallest,
                 dem::rayleigh_time_step(
                     cell.material_of(i), cell.initial_radius_of(i), scaling));
  return smallest;
}

// What the cell at the start says.
void look_at(const dem::UnitCell &cell,
             const coupling::MaterialChoice &choice,
             double pressure,
             MaterialTrial &trial)
{
  trial.grains = cell.size();
  const dem::Dynamics &dynamics = choice.driving.dynamics;
  trial.rayleigh_time_step =
      smallest_rayleigh_step(cell, dynamics.density_scaling);
  trial.measures = dem::measure_dynamics(cell, dynamics, pressure);
  trial.remarks = dem::judge(cell, choice.driving, pressure);
  // A cell of more grains is wider.
  const double wider =
      choice.packing_files.empty()
          ? std::cbrt(double(choice.packing.grain_count) / double(cell.size()))
          : 1;
  std::erase_if(trial.remarks, [&](const dem::Remark &remark) {
    return remark.kind == dem::Remark::Kind::box_narrow &&
           remark.value * wider >= remark.bound;
  });
  if (choice.driving.method == dem::Method::dynamics)
    trial.increment =
        std::min(trial.increment,
                 most_sweeps_per_step * dynamics.strain_rate *
                     dynamics.time_step_fraction * trial.rayleigh_time_step);
}

class Trial
{
public:
  Trial(const coupling::MaterialChoice &choice, double increment)
      : choice_(choice)
  {
    trial_.increment = increment;
    choice_.threads = 1;
    if (choice_.packing_files.empty())
      choice_.packing.grain_count =
          std::min(choice_.packing.grain_count, most_grains);
    const double begin = now();
    material_ = coupling::make_material(choice_, 1);
    trial_.packing_seconds = now() - begin;
  }

  MaterialTrial work(const coupling::MaterialChoice &whole)
  {
    const fem::Response start = respond(0);
    if (material_.cells)
      look_at(
          material_.cells->cell(0), whole, -trace(start.stress) / 3, trial_);
    press();
    return std::move(trial_);
  }

private:
  // A step along z that is kept unless it fails.
  fem::Response respond(double strain)
  {
    fem::Deformation deformation;
    for (unsigned i = 0; i < 3; ++i)
      deformation.relative_F[i][i] = i == 2 ? std::exp(-strain) : 1;
    fem::Response response;
    material_.points->begin_attempt();
    material_.points->evaluate(
        {&deformation, 1}, fem::Want::stress_and_tangent, {&response, 1});
    if (response.status == fem::Status::failed) {
      trial_.problem = material_.cells ? material_.cells->report().problem
                                       : "the law has no answer";
      return response;
    }
    material_.points->commit();
    std::vector<char> bytes;
    material_.points->pack(0, bytes);
    trial_.states.push_back({response.relative_density,
                             0 - response.stress[2][2],
                             double(bytes.size())});
    return response;
  }

  void press()
  {
    const double begin = now();
    double evaluations = 0;
    unsigned steps = 0;
    for (double strain = 0; strain < most_strain; strain += trial_.increment) {
      if (trial_.out_of_time = now() - begin > most_seconds; trial_.out_of_time)
        break;
      respond(trial_.increment);
      if (!trial_.problem.empty() ||
          trial_.states.back().relative_density > solid)
        break;
      if (material_.cells)
        evaluations += material_.cells->report().mean_evaluations();
      ++steps;
    }
    const double count = std::max(steps, 1u);
    trial_.seconds_per_step = (now() - begin) / count;
    trial_.evaluations_per_step = evaluations / count;
  }

  coupling::MaterialChoice choice_;
  coupling::Material material_;
  MaterialTrial trial_;
};
} // namespace

std::optional<double> MaterialTrial::density_at(double axial_pressure) const
{
  for (const State &state : states)
    if (state.axial_pressure >= axial_pressure)
      return state.relative_density;
  return {};
}

double MaterialTrial::bytes_at(double relative_density) const
{
  for (const State &state : states)
    if (state.relative_density >= relative_density)
      return state.bytes;
  return states.empty() ? 0 : states.back().bytes;
}

MaterialTrial try_material(const coupling::MaterialChoice &choice,
                           double increment)
{
  return Trial(choice, increment).work(choice);
}
} // namespace tamp::apps
