// SPDX-License-Identifier: BSD-3-Clause
#include <coupling/material_factory.h>
#include <coupling/packing_library.h>
#include <coupling/unit_cell_points.h>
#include <fem/laws/continuum_points.h>
#include <fem/laws/drucker_prager_cap.h>
#include <fem/laws/elastic.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace tamp::coupling
{
namespace
{
using fem::DensityTable;

DensityTable table(const std::vector<double> &nodes,
                   const std::vector<double> &values,
                   const std::string &name)
{
  if (nodes.size() == 1 && values.size() == 1)
    return DensityTable(values[0]);
  return DensityTable({nodes, values}, name);
}

fem::PorousElasticity elasticity(const ElasticTable &choice)
{
  return {
      table(choice.relative_density, choice.youngs_modulus, "Young's modulus"),
      table(choice.relative_density, choice.poissons_ratio, "Poisson's ratio")};
}

// The law reads p_b over the plastic volumetric strain since the first density
// of the table; above the table the last line goes on.
DensityTable hardening(const CapChoice &choice)
{
  if (choice.hardening_density.empty())
    throw std::invalid_argument("the hardening table is empty");
  std::vector<double> strains;
  for (const double density : choice.hardening_density)
    strains.push_back(std::log(density / choice.hardening_density.front()));
  return DensityTable({strains, choice.hydrostatic_yield},
                      "hydrostatic yield pressure",
                      DensityTable::Shape::increasing,
                      DensityTable::Above::extend);
}

template <class Law>
Material make_points(const Law &law, std::size_t count)
{
  return {std::make_unique<fem::ContinuumPoints<Law>>(law, count), nullptr};
}

Material make_elastic(const ElasticChoice &choice, std::size_t count)
{
  fem::ElasticParameters parameters;
  parameters.elasticity = elasticity(choice.elasticity);
  parameters.initial_relative_density = choice.initial_relative_density;
  return make_points(fem::Elastic(parameters), count);
}

Material make_cap(const CapChoice &choice, std::size_t count)
{
  return make_points(fem::DruckerPragerCap(cap_parameters(choice)), count);
}

// Of the run's packings, that of the first point to be made.
std::size_t first_packing(const MaterialChoice &choice)
{
  return choice.first_packing + (choice.same_packing ? 0 : choice.first_point);
}

StoredPackings find_packings(const MaterialChoice &choice,
                             std::size_t count,
                             const std::function<void(std::size_t)> &progress)
{
  if (choice.packing_files.empty()) {
    choice.packing.check();
    return {make_packings(choice.packing,
                          count,
                          choice.same_packing,
                          choice.threads,
                          progress,
                          first_packing(choice)),
            History::kept};
  }
  return read_packings(
      choice.same_packing
          ? std::vector{choice.packing_files[choice.first_packing %
                                             choice.packing_files.size()]}
          : choice.packing_files,
      choice.packing,
      count,
      first_packing(choice));
}

Material make_cells(const MaterialChoice &choice,
                    std::size_t count,
                    const std::function<void(std::size_t)> &progress)
{
  choice.driving.check();
  CellPointsOptions options;
  options.driving = choice.driving;
  options.threads = choice.threads;
  options.warm = choice.warm;
  options.first_point = choice.first_point;
  StoredPackings packings = find_packings(choice, count, progress);
  auto points =
      std::make_unique<UnitCellPoints>(std::move(packings.cells), options);
  Material material;
  material.cells = points.get();
  material.points = std::move(points);
  material.history = packings.history;
  return material;
}
} // namespace

fem::DruckerPragerCapParameters cap_parameters(const CapChoice &choice)
{
  fem::DruckerPragerCapParameters parameters;
  parameters.elasticity = elasticity(choice.elasticity);
  parameters.cohesion =
      table(choice.relative_density, choice.cohesion, "cohesion");
  parameters.friction_angle =
      table(choice.relative_density, choice.friction_angle, "friction angle");
  parameters.eccentricity = table(
      choice.relative_density, choice.cap_eccentricity, "cap eccentricity");
  parameters.hardening = hardening(choice);
  parameters.reference_density = choice.hardening_density.front();
  parameters.initial_relative_density = choice.initial_relative_density;
  parameters.transition = choice.transition;
  parameters.dilation = choice.dilation;
  parameters.integration_tolerance = choice.integration_tolerance;
  return parameters;
}

Material make_material(const MaterialChoice &choice,
                       std::size_t count,
                       const std::function<void(std::size_t)> &progress)
{
  switch (choice.kind) {
  case MaterialKind::unit_cell:
    return make_cells(choice, count, progress);
  case MaterialKind::elastic:
    return make_elastic(choice.elastic, count);
  case MaterialKind::drucker_prager_cap:
    return make_cap(choice.cap, count);
  case MaterialKind::modified_cam_clay:
    return make_points(fem::ModifiedCamClay(choice.cam_clay), count);
  case MaterialKind::fkm_gurson:
    return make_points(fem::FkmGurson(choice.fkm_gurson), count);
  }
  throw std::invalid_argument("unknown kind of material");
}
} // namespace tamp::coupling
