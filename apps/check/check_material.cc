// SPDX-License-Identifier: BSD-3-Clause
#include <apps/check/check_sections.h>
#include <apps/run/run_material.h>
#include <fem/laws/cap_remarks.h>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tamp::apps
{
namespace
{
using coupling::MaterialChoice;
using coupling::MaterialKind;

std::string name_of(MaterialKind kind)
{
  switch (kind) {
  case MaterialKind::unit_cell:
    return "unit cells of grains";
  case MaterialKind::elastic:
    return "elastic";
  case MaterialKind::drucker_prager_cap:
    return "Drucker-Prager cap";
  case MaterialKind::modified_cam_clay:
    return "Modified Cam-Clay";
  case MaterialKind::fkm_gurson:
    return "FKM-Gurson";
  }
  return {};
}

// The axial pressure of the trial at round densities.
std::string curve_of(const MaterialTrial &trial)
{
  std::vector<std::string> parts;
  double next = 0;
  for (const MaterialTrial::State &state : trial.states) {
    if (state.relative_density < next)
      continue;
    parts.push_back(fmt::format("{:.3g} MPa at {:.3g}",
                                state.axial_pressure / 1e6,
                                state.relative_density));
    next = state.relative_density + 0.1;
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

void say_contacts(CheckReport &report, const dem::PackingRequest &packing)
{
  for (const std::string &doubt :
       {adhesion_doubt(packing.contact), adjusted_pressure_doubt(packing)})
    if (!doubt.empty())
      report.doubt(doubt);
}

void say_method(CheckReport &report,
                const dem::Driving &driving,
                const MaterialTrial &trial)
{
  if (driving.method == dem::Method::quasi_static) {
    report.line("method",
                fmt::format("quasi-static: rate independent, unbalance below "
                            "{:.2g}",
                            driving.quasi_static.unbalance_tolerance));
    return;
  }
  const dem::Dynamics &dynamics = driving.dynamics;
  report.line("method",
              fmt::format("dynamics at {:.3g} 1/s, density x {:.3g}",
                          dynamics.strain_rate,
                          dynamics.density_scaling));
  report.line("quasi-static number",
              fmt::format("inertial number {:.3g} at the start, where it is "
                          "largest (quasi-static: below 1e-3); scaling number "
                          "{:.3g}",
                          trial.measures.inertial_number,
                          trial.measures.scaling_number));
  const double step = dynamics.time_step_fraction * trial.rayleigh_time_step;
  report.line("Rayleigh share",
              fmt::format("{:.3g} of the Rayleigh time step {:.3g} s: {:.3g} "
                          "time steps for a strain of 1e-3",
                          dynamics.time_step_fraction,
                          trial.rayleigh_time_step,
                          1e-3 / dynamics.strain_rate / step));
}

void say_grains(CheckReport &report,
                const MaterialChoice &material,
                const MaterialTrial &trial)
{
  const dem::PackingRequest &packing = material.packing;
  const bool made = material.packing_files.empty();
  const std::size_t grains = made ? packing.grain_count : trial.grains;
  report.line("grains", fmt::format("{} a cell", grains));
  report.line("packing",
              fmt::format("relative density {:.4g} at {:.3g} MPa{}",
                          trial.states.front().relative_density,
                          trial.states.front().axial_pressure / 1e6,
                          grains == trial.grains
                              ? ""
                              : fmt::format(" (in a sample of {} grains)",
                                            trial.grains)));
  say_method(report, material.driving, trial);
  say_contacts(report, packing);
  for (const dem::Remark &remark : trial.remarks)
    report.doubt(remark.text);
}
} // namespace

void say_material(CheckReport &report,
                  const MaterialChoice &material,
                  const MaterialTrial &trial)
{
  report.section("Material");
  report.line("law", name_of(material.kind));
  if (material.kind == MaterialKind::unit_cell)
    say_grains(report, material, trial);
  else
    report.line("start",
                fmt::format("relative density {:.4g}",
                            trial.states.front().relative_density));
  report.line("between smooth walls",
              curve_of(trial) +
                  (trial.out_of_time ? " (as far as tried)" : ""));
  if (!trial.problem.empty())
    report.doubt(fmt::format(
        "pressed between smooth walls the material fails at a relative "
        "density of {:.3g}: {}",
        trial.states.back().relative_density,
        trial.problem));
  if (material.kind == MaterialKind::drucker_prager_cap)
    for (const fem::Remark &remark :
         fem::remarks(coupling::cap_parameters(material.cap)))
      report.doubt("Material/Drucker-Prager cap: " + remark.text());
}

void say_pair(CheckReport &report, const RunInput &input)
{
  report.section("Pair");
  const PairInput &pair = input.pair;
  const dem::PairMaterial material =
      dem::pair_material(pair.material, pair.partner);
  const double radius = dem::shape_of(pair.first, pair.second).reduced_radius;
  report.line("contact",
              fmt::format("E* = {:.4g} GPa, R* = {:.4g} um",
                          material.effective_modulus / 1e9,
                          1e6 * radius));
  say_contacts(report, input.material.packing);
  for (const dem::Remark &remark : dem::judge_contacts(
           input.material.packing.contact, material, radius, "the contact"))
    report.doubt(remark.text);
  if (pair.impact)
    report.line("impact",
                fmt::format("{:.4g} time steps in an elastic contact",
                            pair.time_steps));
  for (std::size_t i = 0; !pair.impact && i < pair.stages.size(); ++i)
    report.line(fmt::format("stage {}", i + 1), pair.stages[i].text);
}
} // namespace tamp::apps
