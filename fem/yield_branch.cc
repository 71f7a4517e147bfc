// SPDX-License-Identifier: BSD-3-Clause
#include <fem/stress_search.h>
#include <fem/yield_branch.h>

#include <stdexcept>

namespace tamp::fem
{
namespace
{
using Control = ComponentTarget::Control;
constexpr unsigned xx = 0, yy = 1, zz = 2;
constexpr unsigned unloading_steps = 10;

// Mean stress of point 0, tension positive [Pa]; zero if it fails.
double mean_stress(MaterialPoints &points)
{
  path::Probe probe(points);
  return trace(probe.evaluate(dealii::unit_symmetric_tensor<3>(), Want::stress)
                   .stress) /
         3;
}

PathStage at_rest()
{
  PathStage stage;
  stage.components.fill({Control::strain, 0, true});
  return stage;
}

// @param mean  stress where the branch begins, tension positive [Pa]
PathStage stage_of(BranchKind kind, double mean, double strain)
{
  PathStage stage = at_rest();
  stage.name = words_of(kind);
  stage.components[zz] = {Control::strain, -strain, true};
  switch (kind) {
  case BranchKind::extension:
    stage.components[zz].value = strain;
    [[fallthrough]];
  case BranchKind::compression:
    stage.axial_share = 0.5;
    stage.deviatoric = true;
    for (const unsigned i : {xx, yy})
      stage.components[i] = {Control::stress, 1.5 * mean, false};
    break;
  case BranchKind::triaxial:
    stage.deviatoric = true;
    for (const unsigned i : {xx, yy})
      stage.components[i] = {Control::stress, mean, false};
    break;
  case BranchKind::isotropic:
    for (const unsigned i : {xx, yy})
      stage.components[i] = stage.components[zz];
    break;
  case BranchKind::uniaxial:
    break;
  }
  return stage;
}

bool sheared(BranchKind kind)
{
  return kind != BranchKind::isotropic && kind != BranchKind::uniaxial;
}
} // namespace

std::string words_of(BranchKind kind)
{
  switch (kind) {
  case BranchKind::compression:
    return "sheared by axial compression at constant pressure";
  case BranchKind::extension:
    return "sheared by axial extension at constant pressure";
  case BranchKind::triaxial:
    return "compressed along the axis at constant lateral stress";
  case BranchKind::isotropic:
    return "compressed isotropically";
  case BranchKind::uniaxial:
    return "compressed along the axis, lateral strains held";
  }
  throw std::invalid_argument("unknown kind of branch");
}

PathEnd
unload_to(MaterialPoints &points, double pressure, const BranchDriving &driving)
{
  PathStage stage = at_rest();
  for (const unsigned i : {xx, yy, zz})
    stage.components[i] = {Control::stress, -pressure, false};
  stage.minimum_steps = unloading_steps;
  if (driving.turn)
    driving.turn();
  return drive_path(points, {stage}, {}, {}, driving.stress_tolerance);
}

BranchEnd drive_branch(MaterialPoints &points,
                       BranchKind kind,
                       const YieldLimits &limits,
                       const ModuliOverPressure &moduli,
                       const BranchDriving &driving)
{
  YieldSearch search(limits, moduli);
  if (driving.turn)
    driving.turn();
  const double mean = mean_stress(points);
  std::vector<PathStage> stages{stage_of(kind, mean, driving.largest_strain)};
  stages[0].maximum_increment = driving.increment;
  stages[0].enough = [&] { return search.yielded(); };
  if (sheared(kind)) {
    stages.push_back(stages[0]);
    stages[1].maximum_increment = driving.coarse_increment;
    stages[1].enough = [&] { return !search.yielded() || search.ended(); };
  }
  BranchEnd result;
  result.end = drive_path(
      points,
      stages,
      {},
      [&](const PathRecord &record) { search.take(record); },
      driving.stress_tolerance);
  result.points = search.points(sheared(kind));
  return result;
}
} // namespace tamp::fem
