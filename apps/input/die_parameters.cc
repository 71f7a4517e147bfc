// SPDX-License-Identifier: BSD-3-Clause
#include <apps/input/input_sections.h>
#include <apps/input/parameter_table.h>
#include <apps/input/schedule.h>
#include <apps/input/value_checks.h>
#include <fem/die_mesh.h>
#include <fem/punch_area.h>
#include <fem/tool_surface.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tamp::apps
{
namespace
{
constexpr Range a_strain{0, 0.1, true, false};

void declare_schedule(ParameterTable &table)
{
  table.enter("Schedule");
  table.text(
      "Stages",
      "press to density 0.85; unload to 5 % of peak; eject by 1 mm "
      "holding 5 % of peak",
      "Divided by semicolons: press (upper, lower or both: the punches; "
      "nothing "
      "said: upper) to density D, displacement L (of each moving punch), force "
      "F or pressure P; unload (the punch that pressed; upper if both did) to "
      "R % of peak, force F, pressure P, to nothing (until it has left the "
      "compact), or by L; eject to rim (until the upper face is there), to out "
      "(until the compact has left the die) or by L, holding R % of peak "
      "(upper "
      "punch) or freely (without it), by withdrawal (the die is drawn down; "
      "otherwise the lower punch goes up); hold N steps. Nothing said, unit "
      "cells of grains without adhesion are ejected holding 5 % of peak, all "
      "else freely");
  table.flag("Floating die",
             false,
             "Friction alone carries the die while punches press, hold and "
             "unload; it stands still while the compact is ejected");
  table.leave();
}

void declare_tolerances(ParameterTable &table)
{
  table.text("Force tolerance",
             "automatic",
             "Unbalanced force over reaction force at equilibrium; automatic: "
             "1e-3 for unit cells, 1e-8 for continuum laws");
  table.text("Force floor",
             "automatic",
             "Share of their peak that reaction forces count as at least in "
             "the force tolerance; automatic: 0.1 for unit cells, whose noise "
             "does not fall with the force, 1e-4 for continuum laws");
  table.quantity("Displacement tolerance",
                 "1e-2",
                 dimension::number,
                 a_strain,
                 "Last change of the displacement over the step's increment, "
                 "which counts as at least 0.5 % of the height");
  table.choice("Linear algebra",
               "petsc",
               {"petsc", "trilinos"},
               "Who solves linear systems");
  table.choice("Linear solver",
               "automatic",
               {"automatic", "direct", "iterative"},
               "direct: MUMPS; iterative: Krylov with algebraic multigrid "
               "(GAMG, ML); automatic: iterative in three dimensions above "
               "20000 unknowns");
  table.choice("Element",
               "standard",
               {"standard", "f-bar"},
               "f-bar: volume changes as at the centre of the element, which "
               "frees nearly dense powder from locking");
  table.choice("Nonlinear method",
               "automatic",
               {"automatic", "newton", "anderson"},
               "newton: a new matrix every iteration; anderson: one a step, "
               "accelerated; automatic: anderson for unit cells");
  table.integer("Maximum iterations", 20, 1, "Of a step before it is cut");
  table.integer(
      "Anderson depth", 5, 0, "Earlier iterations that the acceleration uses");
  table.choice(
      "Guard against opening",
      "automatic",
      {"automatic", "on", "off"},
      "Reject steps in which a point opens: loses 70 % of its pressure "
      "though no tool gives way, grows by 0.2 %, or by 5 % since the "
      "ejection began; automatic: on for unit cells");
}

void declare_steps(ParameterTable &table)
{
  table.quantity("First step",
                 "1e-3",
                 dimension::number,
                 a_strain,
                 "Mean axial strain of the first step of a stage");
  table.quantity("Maximum step",
                 "5e-3",
                 dimension::number,
                 a_strain,
                 "Mean axial strain of a step while pressing");
  table.quantity("Maximum unloading step",
                 "1e-3",
                 dimension::number,
                 a_strain,
                 "Mean axial strain of a step while unloading and ejecting");
  table.quantity("Minimum step",
                 "1e-6",
                 dimension::number,
                 a_strain,
                 "A step that would be smaller ends the run");
  table.quantity("Step growth",
                 "1.25",
                 dimension::number,
                 {1, 10, false, false},
                 "Factor after a step that went well");
  table.quantity("Step cut",
                 "0.5",
                 dimension::number,
                 {0, 1, true, true},
                 "Factor after a step that failed");
}

bool automatic(const ParameterTable &table,
               const std::string &path,
               const std::string &yes,
               bool otherwise)
{
  const std::string word = table.word(path);
  return word == "automatic" ? otherwise : word == yes;
}

fem::ImportedMesh make_mesh(const ParameterTable &table,
                            const fem::DieGeometry &geometry)
{
  // Names at the front are found first among those of one length.
  check_values(table,
               {"Die/Shape",
                "Die/Upper punch",
                "Die/Lower punch",
                "Die/Radius",
                "Die/Core radius",
                "Die/Side",
                "Die/Corner radius",
                "Die/Fill height",
                "Die/Exit taper angle",
                "Die/Exit taper length"},
               [&] { geometry.check(); });
  const char *source =
      geometry.mesh_file.empty() ? "Die/Shape" : "Die/Mesh file";
  try {
    fem::ImportedMesh imported = fem::die_mesh(geometry);
    // Tools that cannot be read off the mesh are refused before the run.
    fem::make_tools(geometry, imported.mesh);
    return imported;
  } catch (const std::runtime_error &error) {
    table.complain(source, error.what());
  } catch (const std::invalid_argument &error) {
    table.complain(source, error.what());
  }
}

fem::LinearMethod chosen_method(const std::string &word)
{
  if (word == "automatic")
    return fem::LinearMethod::automatic;
  return word == "direct" ? fem::LinearMethod::direct
                          : fem::LinearMethod::iterative;
}

/// A share above 0 and up to 0.1, or the one that is chosen automatically.
double small_share(const ParameterTable &table,
                   const std::string &path,
                   double automatic)
{
  if (table.word(path) == "automatic")
    return automatic;
  try {
    const double value = parse_quantity(table.word(path), dimension::number);
    if (a_strain.contains(value))
      return value;
  } catch (const InputError &) {
  }
  table.complain(path, "expected automatic or a number above 0 and up to 0.1");
}

void read_solver(const ParameterTable &table, bool cells, fem::DieSettings &die)
{
  fem::SolverSettings &solver = die.solver;
  solver.method = automatic(table, "Solver/Nonlinear method", "anderson", cells)
                      ? fem::NonlinearMethod::anderson
                      : fem::NonlinearMethod::newton;
  solver.force_tolerance =
      small_share(table, "Solver/Force tolerance", cells ? 1e-3 : 1e-8);
  solver.least_reaction =
      small_share(table, "Solver/Force floor", cells ? 0.1 : 1e-4);
  solver.f_bar = table.word("Solver/Element") == "f-bar";
  solver.linear.method = chosen_method(table.word("Solver/Linear solver"));
  solver.linear.algebra = table.word("Solver/Linear algebra") == "trilinos"
                              ? fem::LinearAlgebra::trilinos
                              : fem::LinearAlgebra::petsc;
  solver.displacement_tolerance = table.number("Solver/Displacement tolerance");
  solver.maximum_iterations =
      static_cast<unsigned>(table.whole("Solver/Maximum iterations"));
  solver.anderson_depth =
      static_cast<unsigned>(table.whole("Solver/Anderson depth"));
  solver.guard_against_opening =
      automatic(table, "Solver/Guard against opening", "on", cells);
  fem::StepLimits &steps = die.steps;
  steps.first = table.number("Solver/First step");
  steps.maximum = table.number("Solver/Maximum step");
  steps.unloading = table.number("Solver/Maximum unloading step");
  steps.minimum = table.number("Solver/Minimum step");
  steps.growth = table.number("Solver/Step growth");
  steps.cut = table.number("Solver/Step cut");
  if (steps.minimum >= steps.first)
    table.complain("Solver/Minimum step",
                   "expected less than Solver/First step = " +
                       table.word("Solver/First step"));
}

/// What grains without adhesion cannot do; empty if they can.
std::string problem_of_loose_grains(const fem::Stage &stage)
{
  const std::string instead =
      ", or grains that hold together: Contact/Normal law = thornton-ning-jkr "
      "or jkr with a Contact/Work of adhesion";
  if (stage.kind == fem::StageKind::unload && stage.frees())
    return "unit cells of grains without adhesion cannot be unloaded to no "
           "force at all: they then keep no stress, and any opening is an "
           "equilibrium. Expected a few per cent of the peak, for example "
           "'unload to 5 % of peak'" +
           instead;
  if (stage.kind == fem::StageKind::eject && stage.frees())
    return "unit cells of grains without adhesion cannot be ejected freely: "
           "they fall apart as soon as the axial stress is gone. Expected an "
           "upper punch that keeps a few per cent of the peak, for example "
           "'eject to rim holding 5 % of peak'" +
           instead;
  if (stage.target == fem::StageTarget::out)
    return "unit cells of grains without adhesion cannot be pushed out of the "
           "die: they fall apart as soon as the wall is gone. Expected 'eject "
           "to rim holding 5 % of peak' at most" +
           instead;
  return {};
}

/// Of the powder, from the highest node of the upper punch to the lowest of
/// the lower one [m].
double height_between_punches(const fem::Mesh &mesh)
{
  const auto z = [&](unsigned node) { return mesh.nodes[node][2]; };
  return z(std::ranges::max(mesh.tools[fem::upper_punch].nodes, {}, z)) -
         z(std::ranges::min(mesh.tools[fem::lower_punch].nodes, {}, z));
}

void read_schedule(const ParameterTable &table,
                   const coupling::MaterialChoice &material,
                   double punch_area,
                   fem::DieSettings &die)
{
  const std::string path = "Schedule/Stages";
  const bool loose = material.kind == coupling::MaterialKind::unit_cell &&
                     !material.packing.contact.adheres();
  try {
    die.stages =
        parse_schedule(table.word(path), {punch_area, loose ? 0.05 : 0.0});
  } catch (const InputError &error) {
    table.complain(path, error.what());
  }
  for (const fem::Stage &stage : die.stages)
    if (const std::string problem = problem_of_loose_grains(stage);
        loose && !problem.empty())
      table.complain(path, problem);
  die.floating_die = table.on("Schedule/Floating die");
}
} // namespace

void declare_press(ParameterTable &table)
{
  declare_schedule(table);
  table.enter("Solver");
  declare_tolerances(table);
  declare_steps(table);
  table.leave();
}

fem::ImportedMesh read_press(const ParameterTable &table,
                             const coupling::MaterialChoice &material,
                             fem::DieSettings &die)
{
  const bool cells = material.kind == coupling::MaterialKind::unit_cell;
  fem::ImportedMesh imported = make_mesh(table, die.geometry);
  die.geometry.section = imported.mesh.section;
  read_schedule(
      table, material, fem::punch_area(imported.mesh, fem::upper_punch), die);
  read_solver(table, cells, die);
  check_values(table,
               {"Schedule/Stages",
                "Schedule/Floating die",
                "Die/Radius",
                "Die/Fill height",
                "Die/Wall friction coefficient",
                "Solver/Force tolerance",
                "Solver/Displacement tolerance",
                "Solver/Maximum iterations",
                "Solver/First step",
                "Solver/Maximum step",
                "Solver/Maximum unloading step",
                "Solver/Minimum step",
                "Solver/Step growth",
                "Solver/Step cut"},
               [&] {
                 die.check();
                 die.check_way(height_between_punches(imported.mesh));
               });
  return imported;
}
} // namespace tamp::apps
